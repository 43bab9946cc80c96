#include <numeric>
#include <utility>

#include "abflat/pack_layout.h"
#include "io/split_vertices.h"

namespace abflat {

PackedVertices packedVertices(const PolygonMesh& mesh, const PackLayoutResult& result) {
  SplitVertices split =
      splitVertices(mesh.vertexCount(), mesh.faceVertices, result.uv, result.cornerUv);
  PackedVertices out;
  out.vertexMap.resize(mesh.vertexCount());
  std::iota(out.vertexMap.begin(), out.vertexMap.end(), 0u);
  out.vertexMap.insert(out.vertexMap.end(), split.copied.begin(), split.copied.end());
  out.uv = std::move(split.uv);
  out.triangles.reserve(result.triangleCorners.size());
  for (const std::uint32_t c : result.triangleCorners) out.triangles.push_back(split.ofCorner[c]);
  out.islandOfTriangle.reserve(result.triangleCorners.size() / 3);
  std::uint32_t f = 0;
  for (std::size_t i = 0; i < result.triangleCorners.size(); i += 3) {
    while (mesh.faceOffsets[f + 1] <= result.triangleCorners[i]) ++f;
    out.islandOfTriangle.push_back(result.islandOfFace[f]);
  }
  return out;
}

}  // namespace abflat
