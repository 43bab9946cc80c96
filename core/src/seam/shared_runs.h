#pragma once

#include <vector>

#include "cut/cut_surface.h"
#include "seam/outlines_together.h"

namespace abflat {

/// A path along which two charts touch. Opening it joins two disks into one.
struct SharedRun {
  CutChartId a, b;                   ///< a < b
  std::vector<SurfaceCorner> edges;  ///< half-edges of a, in order
  BoundaryIndex begin;               ///< index of the first edge in the loop of a
  double length = 0, cost = 0;

  void add(const SeamMesh& mesh, SurfaceCorner h) {
    edges.push_back(h);
    length += mesh.length[h];
    cost += mesh.cost[h];
  }
};

/// What is joined together or not at all: a run, and its image if it has another one.
using RunsTogether = std::vector<SharedRun>;

/// The chart on the other side of an edge, if the seam there may be removed.
CutChartId chartBehind(const SeamMesh& mesh, const Seams& kept, const CutSurface& s,
                       SurfaceCorner h);

/// All runs between disks, but for those that go all the way round a chart.
std::vector<SharedRun> sharedRuns(const SeamMesh& mesh, const Seams& kept, const CutSurface& s);

/// Points of the two outlines that the run brings together.
OutlinePairs pairsOf(const SeamMesh& mesh, const CutSurface& s, const SharedRun& run,
                     const Outline& a);

}  // namespace abflat
