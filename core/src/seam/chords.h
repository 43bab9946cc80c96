#pragma once

#include <array>
#include <vector>

#include "seam/path_forest.h"

namespace abflat {

/// A seam that splits a disk in two: an edge and the paths from both of its ends to the boundary.
struct Chord {
  SurfaceCorner h;
  double length = 0;
  double left = 0, right = 0;  ///< area on h's side, and on the other
  double resolved = 0;         ///< share of the given pairs that it separates
};

/// Considers all edges that are not in the forest of paths. In a disk they form a spanning tree of
/// its triangles, so each one splits it in two, and one pass over the tree gives all areas.
class ChordFinder {
 public:
  explicit ChordFinder(const CutPaths& paths);

  /// The chord with the least length / sqrt(smaller area). A chord counts as longer if it does not
  /// separate pairs of boundary half-edges that will overlap. h is none if there is no chord.
  /// `pairs` belong to the chart's loop.
  Chord best(CutChartId chart, const std::vector<std::array<BoundaryIndex, 2>>& pairs);

  /// The chord with the least length / sqrt(smaller area) for the share of the given pairs that it
  /// separates; one that cuts off more than next to nothing unless that takes many times as much.
  /// h is none if none separates any.
  Chord apart(CutChartId chart, const std::vector<std::array<BoundaryIndex, 2>>& pairs);

  /// The best chord, or if all of them would cut off next to nothing, the one that cuts off most.
  Chord forHalving(CutChartId chart);

 private:
  Chord chordAt(SurfaceCorner h, CutChartId chart, double leastShare) const;
  void walk(CutChartId chart);
  void numberLoop(CutChartId chart);
  Chord bestApart(CutChartId chart, const std::vector<std::array<BoundaryIndex, 2>>& pairs,
                  double leastShare) const;
  double resolvedShare(SurfaceCorner h,
                       const std::vector<std::array<BoundaryIndex, 2>>& pairs) const;

  const CutPaths paths_;
  const CutSurface& surface_;
  std::vector<SurfaceTriangle> order_;
  IdVector<SurfaceTriangle, SurfaceCorner> parent_;  ///< from each triangle towards the root
  IdVector<SurfaceTriangle, double> area_;           ///< of each subtree
  IdVector<OpenVertex, BoundaryIndex> alongLoop_;    ///< of the boundary vertices seen so far
};

}  // namespace abflat
