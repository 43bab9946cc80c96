#include "cut/filled_table.h"

#include <algorithm>

namespace abflat {

FilledTable filledTable(const SeamMesh& mesh, const IdVector<SurfaceVertex, InputVertex>& vertices,
                        const Seams& seams) {
  FilledTable out;
  std::uint32_t surface = 0;
  while (surface < mesh.triangleCount() && !mesh.isFilling(surface)) ++surface;
  out.surfaceTriangles = surface;
  std::vector<std::uint8_t> isOpen;
  for (std::uint32_t h = 3 * surface; h < mesh.twin.size(); ++h) {
    isOpen.resize(std::max<std::size_t>(isOpen.size(), mesh.hole[h / 3] + 1), 0);
    if (seams[h]) isOpen[mesh.hole[h / 3]] = 1;
  }
  std::vector<std::uint32_t> number(mesh.triangleCount(), kNone);
  std::vector<std::uint32_t> kept;
  for (std::uint32_t f = 0; f < mesh.triangleCount(); ++f) {
    if (mesh.isFilling(f) && isOpen[mesh.hole[f]]) continue;
    number[f] = static_cast<std::uint32_t>(kept.size());
    kept.push_back(f);
    if (f >= surface) out.hole.push_back(mesh.hole[f]);
  }
  for (const std::uint32_t f : kept)
    for (std::uint32_t h = 3 * f; h < 3 * f + 3; ++h) {
      const std::uint32_t o = mesh.twin[h];
      const bool isCut = o == kNone || seams[h] || number[o / 3] == kNone;
      out.table.vertex.push_back(vertices[SurfaceVertex(mesh.vertexOfCorner[h])]);
      out.table.twin.push_back(isCut ? SurfaceCorner() : SurfaceCorner(3 * number[o / 3] + o % 3));
    }
  return out;
}

}  // namespace abflat
