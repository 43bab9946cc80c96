#pragma once

#include <array>
#include <vector>

namespace abflat {

using Point2 = std::array<double, 2>;

/// Convex hull, counter-clockwise without collinear points (Andrew's monotone chain).
std::vector<Point2> convexHull(std::vector<Point2> points);

/// The two points that are farthest apart, the left one first (rotating calipers).
std::array<Point2, 2> diameter(const std::vector<Point2>& points);

}  // namespace abflat
