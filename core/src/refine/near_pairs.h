#pragma once

#include <cstdint>
#include <vector>

namespace abflat {

/// A point of a closed polygon and an edge that it is not on; edge i runs from point i to i + 1.
struct NearPair {
  std::uint32_t point, edge;
};

/// Those at most `reach` apart, by points and then by edges; some that are farther apart may be
/// among them. Close to linear where few are near.
std::vector<NearPair> findNearPairs(const std::vector<double>& points, double reach);

}  // namespace abflat
