#pragma once

#include <vector>

#include "chart/disk_chart.h"

namespace abflat {

/// What moving vertices to other numbers has done.
struct GridRepair {
  bool isValid = false;   ///< every triangle is positively oriented
  std::size_t moved = 0;  ///< vertices
  double farthest = 0;    ///< of them, along either axis
};

/// Triangles that are thinner than numbers can tell are flipped or without area once coordinates
/// are rounded to multiples of `step`. Their vertices are moved to other multiples, at most 12
/// steps along either axis from where they are, until each is positively oriented. `exact`: the
/// layout before rounding; where its boundary turns clockwise it still does.
GridRepair repairOnGrid(const DiskChart& chart, const std::vector<double>& exact, double step,
                        std::vector<double>& uv);

}  // namespace abflat
