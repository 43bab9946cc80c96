#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace abflat {

/// Closed curves. The edges of each run from a point to the next one, and from its last point back
/// to its first; the bounded area is on their left.
struct Curves {
  std::vector<double> points;       ///< 2 coordinates each, finite
  std::vector<std::uint32_t> ends;  ///< one past the index of each curve's last point
};

/// Empty if no two edges meet, except neighbours at their common point, and no place is covered
/// more than once or a negative number of times: then every point that is not on a curve has
/// winding number 0 or 1. Otherwise two edges, given by their first points, that meet or between
/// which a place is covered wrongly; both are the same edge if a single one is enough. Exact, in
/// O(n log n).
std::optional<std::array<std::uint32_t, 2>> findWrongCover(const Curves& curves);

}  // namespace abflat
