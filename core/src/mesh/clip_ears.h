#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/listener.h"
#include "base/point2.h"

namespace abflat {

/// Cuts a polygon of any shape into n - 2 triangles, as indices into `points`, that together have
/// every polygon edge exactly once. They triangulate it properly if it is simple and
/// counter-clockwise. Corners to `keep` do not become ears if that can be avoided. Returns only
/// some of the triangles if `listener` has stopped.
std::vector<std::array<std::uint32_t, 3>> clipEars(std::vector<Point2> points,
                                                   const std::vector<std::uint8_t>& keep,
                                                   const Listener& listener = {});

/// Twice the area of a triangle, positive counter-clockwise.
inline double turnOf(const Point2& a, const Point2& b, const Point2& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

}  // namespace abflat
