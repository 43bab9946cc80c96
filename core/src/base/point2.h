#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace abflat {

/// A point in the plane, such as the uv of a vertex.
using Point2 = std::array<double, 2>;

/// Point i of a list of interleaved coordinates.
inline Point2 pointAt(const std::vector<double>& coordinates, std::size_t i) {
  return {coordinates[2 * i], coordinates[2 * i + 1]};
}
inline void setPoint(std::vector<double>& coordinates, std::size_t i, const Point2& point) {
  coordinates[2 * i] = point[0];
  coordinates[2 * i + 1] = point[1];
}

}  // namespace abflat
