#include "alike/cells.h"

namespace abflat {

Cells cellsOf(const PolygonMesh& mesh, const Triangulation& triangulation,
              const IdVector<SurfaceTriangle, PartId>& part,
              const IdVector<SurfaceCorner, SurfaceCorner>& twin, std::size_t parts) {
  Cells out{mesh, {}, {}, {}, {}, {}, parts};
  out.part.resize(mesh.faceCount());
  out.faceMark.resize(mesh.faceCount(), 0);
  out.twin.resize(mesh.faceVertices.size());
  out.edgeMark.resize(mesh.faceVertices.size(), 0);
  out.face.reserve(mesh.faceVertices.size());
  for (const PolygonFace f : out.part.ids())
    for (std::uint32_t k = out.size(f); k > 0; --k) out.face.push_back(f);
  for (const SurfaceTriangle f : part.ids()) out.part[triangulation.face[f]] = part[f];
  for (const SurfaceCorner h : twin.ids())
    if (!triangulation.isDiagonal[h] && twin[h].exists())
      out.twin[triangulation.corner[h]] = triangulation.corner[twin[h]];
  return out;
}

}  // namespace abflat
