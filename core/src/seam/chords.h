#pragma once

#include <array>
#include <vector>

#include "seam/path_forest.h"

namespace abflat {

/// A seam that splits a disk in two: an edge and the paths from both of its ends to the boundary.
struct Chord {
  SurfaceCorner h;
  double length = 0;
  double left = 0, right = 0;  ///< area on the side of h, and on the other
  double resolved = 0;         ///< share of the pairs asked for that it separates
};

/// All edges off the forest of paths. Those of a disk are a spanning tree of its triangles, so each
/// splits it in two, and one pass over the tree gives all areas.
class ChordFinder {
 public:
  explicit ChordFinder(const CutPaths& paths);

  /// Of least length / sqrt(smaller area), where chords that do not separate pairs of boundary
  /// half-edges which will lie on each other count as longer; h is none when there is none.
  /// `pairs` are of the chart's loop.
  Chord best(CutChartId chart, const std::vector<std::array<BoundaryIndex, 2>>& pairs);

 private:
  Chord chordAt(SurfaceCorner h, CutChartId chart) const;
  void walk(CutChartId chart);
  void numberLoop(CutChartId chart);
  double resolvedShare(SurfaceCorner h,
                       const std::vector<std::array<BoundaryIndex, 2>>& pairs) const;

  const CutPaths paths_;
  const CutSurface& surface_;
  std::vector<SurfaceTriangle> order_;
  IdVector<SurfaceTriangle, SurfaceCorner> parent_;  ///< of the triangle towards the root
  IdVector<SurfaceTriangle, double> area_;           ///< of the subtree
  IdVector<OpenVertex, BoundaryIndex> alongLoop_;    ///< of the boundary vertices seen so far
};

}  // namespace abflat
