#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace abflat {

/// Vertices of a polygon in its own plane, counter-clockwise in all, scaled to about unit size. The
/// plane is that of its area vector along one of the axes.
std::vector<std::array<double, 2>> projectPolygon(const std::vector<double>& positions,
                                                  const std::uint32_t* vertices, std::size_t count);

}  // namespace abflat
