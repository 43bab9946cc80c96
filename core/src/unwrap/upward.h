#pragma once

#include <vector>

#include "base/point2.h"
#include "chart/chart_set.h"

namespace abflat {

/// The mean gradient of height in a chart's layout `uv`: it points to where the mesh's up direction
/// goes, and is as long as the height gained per length. `axis`: of `positions`, 0 to 2.
Point2 upward(const ChartTopology& chart, const std::vector<double>& uv,
              const std::vector<double>& positions, std::size_t axis);

}  // namespace abflat
