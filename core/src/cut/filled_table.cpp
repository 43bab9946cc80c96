#include "cut/filled_table.h"

#include <algorithm>

namespace abflat {
namespace {

/// Whether a seam passes through the filling of a hole.
IdVector<HoleId, std::uint8_t> openHoles(const SeamMesh& mesh, const Seams& seams) {
  IdVector<HoleId, std::uint8_t> out;
  for (const SurfaceCorner h : mesh.fillingCorners()) {
    const HoleId hole = mesh.hole[triangleOf(h)];
    out.resize(std::max<std::size_t>(out.size(), hole + 1), 0);
    if (seams[h]) out[hole] = 1;
  }
  return out;
}

}  // namespace

FilledTable filledTable(const SeamMesh& mesh, const IdVector<SurfaceVertex, InputVertex>& vertices,
                        const Seams& seams) {
  const IdVector<HoleId, std::uint8_t> isOpen = openHoles(mesh, seams);
  FilledTable out;
  IdVector<SurfaceTriangle, SurfaceTriangle> number(mesh.triangleCount());
  std::vector<SurfaceTriangle> kept;
  for (const SurfaceTriangle f : mesh.triangles()) {
    const bool isFilling = mesh.isFilling(f);
    if (isFilling && isOpen[mesh.hole[f]]) continue;
    number[f] = SurfaceTriangle(kept.size());
    kept.push_back(f);
    if (isFilling) out.hole.push_back(mesh.hole[f]);
  }
  out.surfaceTriangles = kept.size() - out.hole.size();
  for (const SurfaceTriangle f : kept)
    for (const SurfaceCorner h : cornersOf(f)) {
      const SurfaceCorner o = mesh.twin[h];
      const bool isCut = !o.exists() || seams[h] || !number[triangleOf(o)].exists();
      out.table.vertex.push_back(vertices[mesh.vertexOfCorner[h]]);
      out.table.twin.push_back(isCut ? SurfaceCorner()
                                     : cornerOf(number[triangleOf(o)], placeInTriangle(o)));
    }
  return out;
}

}  // namespace abflat
