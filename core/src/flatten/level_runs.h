#pragma once

#include <vector>

#include "chart/disk_chart.h"

namespace abflat {

/// A part of an outline that is nearly straight along an axis.
struct LevelRun {
  BoundaryIndex from, to;   ///< its two ends
  std::uint8_t across = 0;  ///< the coordinate that hardly changes: 0 for u, 1 for v
};

struct LevelRuns {
  double turn = 0;    ///< radians, by which the layout has to be turned first
  double share = 0;   ///< of the outline that the runs take up
  double before = 0;  ///< share of the outline that lies along the axes already
  std::vector<LevelRun> runs;
};

/// What an outline needs to be seen as a polygon of level sides, and each of its sides.
struct LevelLimits {
  double leastAgreement = 0.4;   ///< of its edges on two axes, from 0 to 1
  double mostDeviation = 0.349;  ///< radians, root of the mean square
};

/// Sees the outline of a layout as a polygon of horizontal and vertical sides, and returns those
/// that come near enough. None if no such polygon resembles it. Where a side cannot be straight
/// because triangles would lose their area, it is left out.
LevelRuns findLevelRuns(const DiskChart& chart, const std::vector<double>& uv,
                        const LevelLimits& limits = {});

}  // namespace abflat
