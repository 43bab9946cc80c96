#include "mesh/weld.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "mesh/corner_table.h"
#include "mesh/vertex_table.h"

namespace abflat {
namespace {

using Cell = std::array<std::int64_t, 3>;

/// Vertices that represent others are further apart than the tolerance, so only a limited number
/// fits into a cell. With this size most vertices need to look only in their own cell or in one
/// more.
constexpr double kCellPerTolerance = 4;

/// The first vertex of each place, by cell, in an open-addressing hash table whose lookup order
/// depends on the input alone.
class Places {
 public:
  Places(const std::vector<double>& positions, double reach)
      : positions_(positions),
        reach_(reach),
        cellSize_(kCellPerTolerance * reach),
        next_(positions.size() / 3, kNone) {
    std::size_t size = 16;
    while (size < positions.size() / 3 * 2) size *= 2;
    slots_.assign(size, {{0, 0, 0}, kNone});
    for (std::size_t d = 0; d < 3; ++d) low_[d] = positions.empty() ? 0 : positions[d];
    for (std::size_t i = 0; i < positions.size(); ++i)
      low_[i % 3] = std::min(low_[i % 3], positions[i]);
  }

  /// The first added vertex within reach of v, or kNone.
  std::uint32_t find(std::uint32_t v) const {
    Cell from, to;
    for (std::size_t d = 0; d < 3; ++d) {
      from[d] = cellOf(v, d, -reach_);
      to[d] = cellOf(v, d, reach_);
    }
    std::uint32_t first = kNone;
    Cell c;
    for (c[0] = from[0]; c[0] <= to[0]; ++c[0])
      for (c[1] = from[1]; c[1] <= to[1]; ++c[1])
        for (c[2] = from[2]; c[2] <= to[2]; ++c[2])
          for (std::uint32_t u = slots_[slotOf(c)].first; u != kNone; u = next_[u])
            if (u < first && isWithinReach(u, v)) first = u;
    return first;
  }

  void add(std::uint32_t v) {
    const Cell cell{cellOf(v, 0, 0), cellOf(v, 1, 0), cellOf(v, 2, 0)};
    Slot& slot = slots_[slotOf(cell)];
    slot.cell = cell;
    next_[v] = slot.first;
    slot.first = v;
  }

  bool isEqual(std::uint32_t u, std::uint32_t v) const {
    return at(u, 0) == at(v, 0) && at(u, 1) == at(v, 1) && at(u, 2) == at(v, 2);
  }

 private:
  struct Slot {
    Cell cell;
    std::uint32_t first;  ///< kNone: empty
  };

  bool isWithinReach(std::uint32_t u, std::uint32_t v) const {
    if (reach_ == 0) return isEqual(u, v);
    double square = 0;
    for (std::size_t d = 0; d < 3; ++d) {
      const double x = (at(u, d) - at(v, d)) / reach_;
      square += x * x;
    }
    return square <= 1;
  }
  double at(std::uint32_t v, std::size_t d) const {
    return positions_[3 * static_cast<std::size_t>(v) + d];
  }
  /// Extents may be as large as doubles get, so it works on halves, which do not overflow.
  std::int64_t cellOf(std::uint32_t v, std::size_t d, double shift) const {
    const double from = at(v, d) / 2 - low_[d] / 2 + shift / 2;
    return cellSize_ > 0 ? static_cast<std::int64_t>(std::floor(from / (cellSize_ / 2))) : 0;
  }
  std::size_t slotOf(const Cell& cell) const {
    std::uint64_t hash = 0;
    for (const std::int64_t c : cell) {
      hash = (hash ^ static_cast<std::uint64_t>(c)) * 0x9e3779b97f4a7c15u;
      hash ^= hash >> 32;
    }
    std::size_t i = hash & (slots_.size() - 1);
    while (slots_[i].first != kNone && slots_[i].cell != cell) i = (i + 1) & (slots_.size() - 1);
    return i;
  }

  const std::vector<double>& positions_;
  double reach_, cellSize_;
  std::array<double, 3> low_{};
  std::vector<std::uint32_t> next_;  ///< in the same cell
  std::vector<Slot> slots_;
};

/// Half of the bounding box diagonal, which cannot overflow.
double halfDiagonal(const std::vector<double>& positions) {
  if (positions.empty()) return 0;
  double square = 0, largest = 0;
  std::array<double, 3> extent{};
  for (std::size_t d = 0; d < 3; ++d) {
    double low = positions[d], high = positions[d];
    for (std::size_t i = d; i < positions.size(); i += 3) {
      low = std::min(low, positions[i]);
      high = std::max(high, positions[i]);
    }
    extent[d] = high / 2 - low / 2;
    largest = std::max(largest, extent[d]);
  }
  if (largest == 0) return 0;
  for (const double x : extent) square += x / largest * (x / largest);
  return largest * std::sqrt(square);
}

}  // namespace

Welding weldVertices(const std::vector<double>& positions, double tolerance,
                     const Listener& listener) {
  const auto n = static_cast<std::uint32_t>(positions.size() / 3);
  Welding out;
  out.reach = 2 * tolerance * halfDiagonal(positions);
  out.ofVertex.resize(n);
  Places places(positions, out.reach);
  for (std::uint32_t v = 0; v < n && listener.beat(); ++v) {
    const std::uint32_t found = places.find(v);
    out.ofVertex[v] = found == kNone ? v : found;
    if (found == kNone) {
      places.add(v);
      continue;
    }
    ++out.merged;
    out.isExact = out.isExact && places.isEqual(found, v);
  }
  return out;
}

Welding weldEqualVertices(const std::vector<double>& positions, const Listener& listener) {
  const auto n = static_cast<std::uint32_t>(positions.size() / 3);
  Welding out;
  out.ofVertex.resize(n);
  VertexTable table(n);
  std::vector<std::uint32_t> first;  // of each place
  for (std::uint32_t v = 0; v < n && listener.beat(); ++v) {
    const double* p = &positions[3 * static_cast<std::size_t>(v)];
    const std::uint32_t place = table.vertexAt(p[0], p[1], p[2]);
    if (place == first.size()) first.push_back(v);
    out.ofVertex[v] = first[place];
    out.merged += first[place] != v;
  }
  return out;
}

}  // namespace abflat
