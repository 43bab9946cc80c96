#pragma once

#include "solve/cholesky/graph.h"

namespace abflat {

/// Orders small sets of vertices by minimum degree, counting the neighbours outside the set, which
/// are eliminated later.
class LocalMinimumDegree {
 public:
  explicit LocalMinimumDegree(const WeightedGraph& graph) : g_(graph), local_(graph.size(), 0) {}

  /// Reorders `vertices` in place. Takes O(n^2 + n d^2) time for n vertices with d neighbours.
  void order(std::vector<std::uint32_t>& vertices);

 private:
  const WeightedGraph& g_;
  std::vector<std::uint32_t> local_;  ///< 1 + number in the current set, 0 outside
  std::vector<std::uint32_t> halo_;
  std::vector<std::uint64_t> adjacency_;  ///< bit matrix
};

}  // namespace abflat
