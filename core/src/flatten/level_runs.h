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

/// Sees the outline of a layout as a polygon of horizontal and vertical sides, and returns those
/// that come near enough. None if no such polygon resembles it. Where a side cannot be straight
/// because triangles would lose their area, it is left out.
LevelRuns findLevelRuns(const DiskChart& chart, const std::vector<double>& uv);

}  // namespace abflat
