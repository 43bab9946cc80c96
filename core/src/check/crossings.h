#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace abflat {

/// Pairs of edges of a closed polygon that cross or touch, decided exactly. Neighbouring edges
/// touch at their common corner and count only if one lies on the other. Close to linear unless
/// very many edges are very near each other.
struct Crossings {
  std::size_t count = 0;
  std::vector<std::array<std::uint32_t, 2>>
      first;  ///< pairs of edges i < j in order, edge i from point i to i + 1; if there are too
              ///< many, those found first
};
/// The search ends with the crossing number `most`: there may be as many as pairs of edges.
Crossings findCrossings(const std::vector<double>& points,
                        std::size_t most = std::numeric_limits<std::size_t>::max());

}  // namespace abflat
