#pragma once

#include <vector>

#include "chart/disk_chart.h"

namespace abflat {

/// Scales uv to the chart's 3D area, turns it to lie as `model` does (least squares over all
/// vertices; an empty one turns nothing) and puts the lower left corner of its bounding box at the
/// origin. What has no area keeps its size.
void pose(const DiskChart& chart, const std::vector<double>& model, std::vector<double>& uv);

}  // namespace abflat
