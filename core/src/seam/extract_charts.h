#pragma once

#include <vector>

#include "cut/cut_surface.h"

namespace abflat {

/// Some charts of a cut surface as a surface of their own, open where it was cut. Its mesh is
/// numbered independently.
struct SeamPart {
  SeamMesh mesh;
  IdVector<SurfaceCorner, SurfaceCorner>
      wholeHalfEdge;  ///< in the whole, per half-edge of the part
  IdVector<SurfaceVertex, SurfaceVertex> wholeVertex;

  /// Re-expresses this part, whose whole was the mesh of `between`, in terms of the whole of
  /// `between`.
  void embedIn(const SeamPart& between) {
    for (SurfaceCorner& h : wholeHalfEdge) h = between.wholeHalfEdge[h];
    for (SurfaceVertex& v : wholeVertex) v = between.wholeVertex[v];
  }

  /// Picks the part's vertices from per-vertex values of the whole.
  template <class T>
  IdVector<SurfaceVertex, T> ofVertices(const IdVector<SurfaceVertex, T>& whole) const {
    IdVector<SurfaceVertex, T> out;
    out.reserve(wholeVertex.size());
    for (const SurfaceVertex v : wholeVertex) out.push_back(whole[v]);
    return out;
  }
};
SeamPart extractCharts(const SeamMesh& mesh, const CutSurface& surface,
                       const IdVector<CutChartId, std::uint8_t>& isWanted, const Pulse& pulse = {});

}  // namespace abflat
