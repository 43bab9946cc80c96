#pragma once

#include <vector>

#include "chart/disk_chart.h"

namespace abflat {

/// The result of moving vertices on the grid.
struct GridRepair {
  bool isValid = false;   ///< every triangle is positively oriented
  std::size_t moved = 0;  ///< number of vertices
  double farthest = 0;    ///< longest move along either axis
};

/// Triangles too thin for the grid are flipped or lose their area once coordinates are rounded to
/// multiples of `step`. Moves their vertices to other multiples, by at most 12 steps along either
/// axis, until every triangle is positively oriented. `exact`: the layout before rounding; where
/// its boundary turns clockwise, it still does afterwards.
GridRepair repairOnGrid(const DiskChart& chart, const std::vector<double>& exact, double step,
                        std::vector<double>& uv);

}  // namespace abflat
