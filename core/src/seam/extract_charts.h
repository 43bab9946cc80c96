#pragma once

#include <vector>

#include "cut/cut_surface.h"

namespace abflat {

/// Some charts of a cut surface as a surface of their own, open where it was cut. Its mesh has
/// numbers of its own.
struct SeamPart {
  SeamMesh mesh;
  IdVector<SurfaceCorner, SurfaceCorner> wholeHalfEdge;  ///< what is one of the part in the whole
  IdVector<SurfaceVertex, SurfaceVertex> wholeVertex;

  /// Makes the whole that of `between`, which has been the whole.
  void embedIn(const SeamPart& between) {
    for (SurfaceCorner& h : wholeHalfEdge) h = between.wholeHalfEdge[h];
    for (SurfaceVertex& v : wholeVertex) v = between.wholeVertex[v];
  }

  /// Of what the whole has per vertex, that of the part's.
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
