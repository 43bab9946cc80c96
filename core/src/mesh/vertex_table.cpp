#include "mesh/vertex_table.h"

#include "base/double_bits.h"

namespace abflat {
namespace {

/// Coordinates of scans and grids differ in few bits; all of them must influence the low bits.
std::size_t hashOf(double x, double y, double z) {
  std::uint64_t h = bitsOf(x) * 0x9e3779b97f4a7c15;
  h = ((h ^ (h >> 32)) + bitsOf(y)) * 0xbf58476d1ce4e5b9;
  h = ((h ^ (h >> 32)) + bitsOf(z)) * 0x94d049bb133111eb;
  return static_cast<std::size_t>(h ^ (h >> 32));
}

}  // namespace

VertexTable::VertexTable(std::size_t expectedVertices) {
  std::size_t size = 16;
  while (size < 2 * expectedVertices) size *= 2;
  slots_.resize(size);
  positions_.reserve(3 * expectedVertices);
}

std::uint32_t VertexTable::vertexAt(double x, double y, double z) {
  x += 0.0, y += 0.0, z += 0.0;  // -0 becomes 0
  const std::size_t mask = slots_.size() - 1;
  for (std::size_t i = hashOf(x, y, z) & mask;; i = (i + 1) & mask) {
    const std::uint32_t slot = slots_[i];
    if (slot == 0) {
      positions_.insert(positions_.end(), {x, y, z});
      const auto vertex = static_cast<std::uint32_t>(positions_.size() / 3 - 1);
      slots_[i] = vertex + 1;
      if (2 * (positions_.size() / 3) > slots_.size()) grow();
      return vertex;
    }
    const double* p = &positions_[3 * std::size_t{slot - 1}];
    if (p[0] == x && p[1] == y && p[2] == z) return slot - 1;
  }
}

void VertexTable::grow() {
  slots_.assign(2 * slots_.size(), 0);
  const std::size_t mask = slots_.size() - 1;
  for (std::size_t v = 0; 3 * v < positions_.size(); ++v) {
    std::size_t i = hashOf(positions_[3 * v], positions_[3 * v + 1], positions_[3 * v + 2]) & mask;
    while (slots_[i] != 0) i = (i + 1) & mask;
    slots_[i] = static_cast<std::uint32_t>(v + 1);
  }
}

}  // namespace abflat
