#pragma once

#include <vector>

#include "chart/disk_chart.h"

namespace abflat {

/// Scales uv to the chart's 3D area. A layout without area keeps its size.
void fitArea(const DiskChart& chart, std::vector<double>& uv);

/// Scales uv to the chart's 3D area, rotates it to match `model` (least squares over all vertices;
/// no rotation if empty) and puts the lower left corner of its bounding box at the origin.
void pose(const DiskChart& chart, const std::vector<double>& model, std::vector<double>& uv);

}  // namespace abflat
