#include <utility>

#include "abflat/mesh.h"

namespace abflat {

PolygonMesh makeTriangleMesh(std::vector<double> positions, std::vector<std::uint32_t> indices) {
  PolygonMesh mesh;
  mesh.faceOffsets.resize(indices.size() / 3 + 1);
  for (std::size_t f = 0; f < mesh.faceOffsets.size(); ++f)
    mesh.faceOffsets[f] = static_cast<std::uint32_t>(3 * f);
  mesh.positions = std::move(positions);
  mesh.faceVertices = std::move(indices);
  return mesh;
}

}  // namespace abflat
