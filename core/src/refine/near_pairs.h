#pragma once

#include <cstdint>
#include <functional>
#include <vector>

namespace abflat {

/// A point of a closed polygon and an edge that it is not on; edge i runs from point i to i + 1.
struct NearPair {
  std::uint32_t point, edge;
};

/// All pairs at most `reach` apart, by point and then by edge; may include some that are farther
/// apart. Close to linear if few are near.
std::vector<NearPair> findNearPairs(const std::vector<double>& points, double reach);

/// The same without keeping them, and only for points that are asked for and edges that begin at
/// one; empty: all.
void forNearPairs(const std::vector<double>& points, double reach,
                  const std::vector<std::uint8_t>& isAsked,
                  const std::function<void(const NearPair&)>& use);

}  // namespace abflat
