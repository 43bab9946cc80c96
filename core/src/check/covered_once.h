#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace abflat {

/// Closed curves. The edges of each go from a point to the next one, and from its last point to its
/// first; what they bound is on their left.
struct Curves {
  std::vector<double> points;       ///< 2 coordinates each, finite
  std::vector<std::uint32_t> ends;  ///< index behind each curve's last point
};

/// Nothing when no two edges meet, but for neighbours at their common point, and no place is
/// bounded twice or less than not at all: then every point that is not on a curve has winding
/// number 0 or 1. Otherwise two edges, by their first points, that meet or between which a place is
/// covered wrongly; both are one edge where it takes no other. Exact, in n log n.
std::optional<std::array<std::uint32_t, 2>> findWrongCover(const Curves& curves);

}  // namespace abflat
