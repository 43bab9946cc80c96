#pragma once

#include <cstdint>
#include <vector>

#include "mesh/surface.h"

namespace abflat {

/// What is compared: connected parts of a surface.
using PartId = Id<struct PartTag>;

/// The polygons of a surface as parts are compared: a polygon may be triangulated in many ways, so
/// its triangles do not count. Numbers are those of the welded mesh.
struct Cells {
  const PolygonMesh& mesh;
  IdVector<PolygonCorner, PolygonFace> face;
  IdVector<PolygonFace, PartId> part;             ///< none if the polygon has no triangles
  IdVector<PolygonCorner, PolygonCorner> twin;    ///< of the edge that leaves a corner, in its part
  IdVector<PolygonFace, std::uint64_t> faceMark;  ///< polygons with different marks are not alike
  IdVector<PolygonCorner, std::uint8_t> edgeMark;  ///< likewise
  std::size_t parts = 0;

  PolygonCorner begin(PolygonFace f) const { return PolygonCorner(mesh.faceOffsets[f]); }
  std::uint32_t size(PolygonFace f) const { return mesh.faceOffsets[f + 1] - mesh.faceOffsets[f]; }
  IdRange<PolygonCorner> corners(PolygonFace f) const {
    return {begin(f), PolygonCorner(mesh.faceOffsets[f + 1])};
  }
  /// The neighbours in its polygon.
  PolygonCorner next(PolygonCorner c) const {
    return PolygonCorner(c + 1 == mesh.faceOffsets[face[c] + 1] ? begin(face[c]) : c + 1);
  }
  PolygonCorner prev(PolygonCorner c) const {
    return PolygonCorner((c == begin(face[c]) ? mesh.faceOffsets[face[c] + 1] : c) - 1);
  }
  const double* at(PolygonCorner c) const {
    return &mesh.positions[3 * std::size_t{mesh.faceVertices[c]}];
  }
};

/// `part`: per triangle; all triangles of a polygon are in one. `twin`: as in CornerTable, without
/// edges where parts end.
Cells cellsOf(const PolygonMesh& mesh, const Triangulation& triangulation,
              const IdVector<SurfaceTriangle, PartId>& part,
              const IdVector<SurfaceCorner, SurfaceCorner>& twin, std::size_t parts);

}  // namespace abflat
