#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace abflat {

/// Pairs of edges of a closed polygon that cross or touch, decided exactly. Neighbouring edges
/// touch at their common corner and count only when one lies on the other. Close to linear for
/// curves that do not crumple.
struct Crossings {
  std::size_t count = 0;
  std::vector<std::array<std::uint32_t, 2>>
      first;  ///< the first pairs found, edge i runs from point i to i + 1
};
Crossings findCrossings(const std::vector<double>& points, std::size_t keepFirst = 4096);

}  // namespace abflat
