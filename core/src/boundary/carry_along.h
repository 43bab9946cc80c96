#pragma once

#include <vector>

#include "base/point2.h"
#include "chart/disk_chart.h"

namespace abflat {

/// Moves vertices of the boundary, each by `shift` times its `way`, and carries what lies around
/// them along: the farther away, the less, so that triangles are sheared by a fifth at most and
/// keep their orientation unless they are needles, or ways beside each other differ much.
std::vector<double> carriedAlong(const DiskChart& chart, const std::vector<double>& uv,
                                 const IdVector<BoundaryIndex, double>& shift,
                                 const IdVector<BoundaryIndex, Point2>& way);

}  // namespace abflat
