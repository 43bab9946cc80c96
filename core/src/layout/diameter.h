#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/point2.h"

namespace abflat {

/// Indices of the points on the convex hull, counter-clockwise without collinear points (Andrew's
/// monotone chain). Of several equal points only the first counts.
std::vector<std::uint32_t> convexHull(const std::vector<Point2>& points);

/// Indices of the two points that are farthest apart, the smaller index first. Among pairs equally
/// far apart up to rounding, as on symmetric outlines, the one with the smallest indices wins.
std::array<std::uint32_t, 2> diameter(const std::vector<Point2>& points);

}  // namespace abflat
