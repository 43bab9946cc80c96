#pragma once

#include <cstdint>
#include <vector>

#include "base/point2.h"

namespace abflat {

/// Vertices of a polygon in its own plane, counter-clockwise in all, scaled to about unit size. The
/// plane is that of its area vector along one of the axes.
std::vector<Point2> projectPolygon(const std::vector<double>& positions,
                                   const std::uint32_t* vertices, std::size_t count);

}  // namespace abflat
