#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/point2.h"
#include "base/pulse.h"

namespace abflat {

/// n - 2 triangles, as places in `points`, that together have every edge of a polygon exactly once,
/// whatever its shape; the polygon's own where it is simple and counter-clockwise. Corners to
/// `keep` become no ears where that can be helped. Some of them where `pulse` has stopped.
std::vector<std::array<std::uint32_t, 3>> clipEars(std::vector<Point2> points,
                                                   const std::vector<std::uint8_t>& keep,
                                                   const Pulse& pulse = {});

/// Twice the area of a triangle, positive counter-clockwise.
inline double turnOf(const Point2& a, const Point2& b, const Point2& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

}  // namespace abflat
