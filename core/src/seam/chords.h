#pragma once

#include <array>
#include <vector>

#include "seam/path_forest.h"

namespace abflat {

/// A seam that splits a disk in two: an edge and the paths from both of its ends to the boundary.
struct Chord {
  std::uint32_t h = kNone;
  double length = 0;
  double left = 0, right = 0;  ///< area on the side of h, and on the other
  double resolved = 0;         ///< share of the pairs asked for that it separates
};

/// All edges off the forest of paths. Those of a disk are a spanning tree of its triangles, so each
/// splits it in two, and one pass over the tree gives all areas.
class ChordFinder {
 public:
  ChordFinder(const SeamMesh& mesh, const CutSurface& surface, const PathForest& forest);

  /// Of least length / sqrt(smaller area), where chords that do not separate pairs of boundary
  /// half-edges which will lie on each other count as longer; h is kNone when there is none.
  /// `pairs` are places along the chart's loop.
  Chord best(std::uint32_t chart, const std::vector<std::array<std::uint32_t, 2>>& pairs);

 private:
  Chord chordAt(std::uint32_t h, std::uint32_t chart) const;
  void walk(std::uint32_t chart);
  void numberLoop(std::uint32_t chart);
  double resolvedShare(std::uint32_t h,
                       const std::vector<std::array<std::uint32_t, 2>>& pairs) const;

  const SeamMesh& mesh_;
  const CutSurface& surface_;
  const PathForest& forest_;
  std::vector<std::uint32_t> order_, parent_;  ///< half-edge of the triangle towards the root
  std::vector<double> area_;                   ///< of the subtree
  std::vector<std::uint32_t> place_;  ///< along its loop, per boundary vertex that was numbered
};

void markChord(const SeamMesh& mesh, const CutSurface& surface, const PathForest& forest,
               const Chord& chord, Seams& seams);

}  // namespace abflat
