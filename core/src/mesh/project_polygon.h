#pragma once

#include <cstdint>
#include <vector>

#include "base/point2.h"

namespace abflat {

/// Vertices of a polygon in its own plane, counter-clockwise overall, scaled to about unit size.
/// They are projected along the axis that is closest to the polygon's area vector.
std::vector<Point2> projectPolygon(const std::vector<double>& positions,
                                   const std::uint32_t* vertices, std::size_t count);

/// The same along the area vector itself, so that it does not matter how the polygon is turned.
std::vector<Point2> facePolygon(const std::vector<double>& positions, const std::uint32_t* vertices,
                                std::size_t count);

}  // namespace abflat
