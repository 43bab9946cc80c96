#include "mesh/input_mesh.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace abflat {

const PolygonMesh& InputMesh::extras() const {
  static const PolygonMesh kNoExtras;
  return polygons_ ? *polygons_ : kNoExtras;
}

PolygonMesh InputMesh::copy() const {
  if (polygons_) return *polygons_;
  std::vector<double> positions;
  positions.reserve(3 * vertexCount());
  for (std::size_t v = 0; v < vertexCount(); ++v) {
    const std::array<double, 3> p = position(v);
    positions.insert(positions.end(), p.begin(), p.end());
  }
  std::vector<std::uint32_t> vertices;
  vertices.reserve(cornerCount());
  for (std::size_t c = 0; c < cornerCount(); ++c) vertices.push_back(vertex(c));
  return makeTriangleMesh(std::move(positions), std::move(vertices));
}

int exponentOf(const InputMesh& mesh) {
  double largest = 0;
  for (std::size_t c = 0; c < mesh.cornerCount(); ++c)
    for (const double x : mesh.position(mesh.vertex(c))) largest = std::max(largest, std::abs(x));
  return largest > 0 ? std::ilogb(largest) : 0;
}

}  // namespace abflat
