#pragma once

#include <cstdint>
#include <vector>

#include "base/listener.h"
#include "cut/surface_mesh.h"

namespace abflat {

/// 1 on both sides of a seam. Boundaries are not marked.
using Seams = IdVector<SurfaceCorner, std::uint8_t>;

/// Half-edges of a boundary loop in order, with the surface on their left. Valid as long as its
/// surface exists.
using BoundaryLoop = IdSpan<BoundaryIndex, SurfaceCorner>;

/// The next index along a loop of the given size.
constexpr BoundaryIndex nextAlong(BoundaryIndex i, std::size_t size) {
  return BoundaryIndex((i + 1) % size);
}

/// The surface opened along its seams.
struct CutSurface {
  struct Chart {
    SurfaceTriangle firstTriangle;
    std::uint32_t triangles = 0, vertices = 0, edges = 0;
    std::uint32_t loops = 0;  ///< number of boundary loops
    LoopId firstLoop;         ///< loops of a chart are consecutive
    double area = 0;

    std::int64_t euler() const { return static_cast<std::int64_t>(vertices) - edges + triangles; }
    bool isDisk() const { return loops == 1 && euler() == 1; }
    IdRange<LoopId> loopIds() const { return {firstLoop, LoopId(firstLoop + loops)}; }
  };

  IdVector<SurfaceCorner, SurfaceCorner> twin;  ///< also none on seams
  IdVector<SurfaceCorner, OpenVertex> vertexOfCorner;
  /// The half-edge from which a counter-clockwise turn visits all corners of a vertex.
  IdVector<OpenVertex, SurfaceCorner> outgoing;
  IdVector<OpenVertex, std::uint8_t> isBoundary;
  IdVector<OpenVertex, SurfaceVertex> meshVertex;
  IdVector<SurfaceTriangle, CutChartId> chartOfTriangle;
  std::vector<SurfaceTriangle> triangleOrder;         ///< chart by chart
  IdVector<CutChartId, std::uint32_t> triangleBegin;  ///< size charts + 1
  IdVector<CutChartId, Chart> charts;
  std::vector<SurfaceCorner> loopOrder;       ///< loop by loop
  IdVector<LoopId, std::uint32_t> loopBegin;  ///< size loops + 1

  IdRange<SurfaceCorner> corners() const { return twin.ids(); }
  IdRange<OpenVertex> vertices() const { return outgoing.ids(); }
  std::size_t vertexCount() const { return outgoing.size(); }
  OpenVertex tail(SurfaceCorner h) const { return vertexOfCorner[h]; }
  OpenVertex head(SurfaceCorner h) const { return vertexOfCorner[nextCorner(h)]; }
  CutChartId chartOf(SurfaceCorner c) const { return chartOfTriangle[triangleOf(c)]; }
  CutChartId chartOf(OpenVertex v) const { return chartOf(outgoing[v]); }
  /// Starting with the first one.
  IdSpan<std::size_t, SurfaceTriangle> trianglesOf(CutChartId i) const {
    const std::uint32_t begin = triangleBegin[i];
    return {triangleOrder.data() + begin, triangleBegin[CutChartId(i + 1)] - begin};
  }
  BoundaryLoop loop(LoopId i) const {
    const std::uint32_t begin = loopBegin[i];
    return {loopOrder.data() + begin, loopBegin[LoopId(i + 1)] - begin};
  }
  /// The only loop of a disk.
  BoundaryLoop outline(CutChartId i) const { return loop(charts[i].firstLoop); }
};

/// `listener` only beats here; it cannot stop the work.
CutSurface cutAlong(const SeamMesh& mesh, const Seams& seams, const Listener& listener = {});

}  // namespace abflat
