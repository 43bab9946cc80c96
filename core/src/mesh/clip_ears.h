#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/pulse.h"

namespace abflat {

/// n - 2 triangles, as places in `points`, that together have every edge of a polygon exactly once,
/// whatever its shape; the polygon's own where it is simple and counter-clockwise. Corners to
/// `keep` become no ears where that can be helped. Some of them where `pulse` has stopped.
std::vector<std::array<std::uint32_t, 3>> clipEars(std::vector<std::array<double, 2>> points,
                                                   const std::vector<std::uint8_t>& keep,
                                                   const Pulse& pulse = {});

/// Twice the area of a triangle, positive counter-clockwise.
inline double turnOf(const std::array<double, 2>& a, const std::array<double, 2>& b,
                     const std::array<double, 2>& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

}  // namespace abflat
