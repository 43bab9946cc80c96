#pragma once

#include "solve/cholesky/graph.h"

namespace abflat {

/// A smaller graph of the same shape: clusters of about four neighbouring vertices become one.
struct CoarseGraph {
  WeightedGraph graph;
  std::vector<std::uint32_t> edgeWeight;  ///< per neighbour: edges of the first graph it stands for
  std::vector<std::uint32_t> cluster;     ///< vertex of the finer graph -> vertex of this one
};

/// `edgeWeight` of the finer graph; empty: all 1. Another seed makes other clusters.
CoarseGraph coarsen(const WeightedGraph& fine, const std::vector<std::uint32_t>& edgeWeight,
                    std::uint32_t seed = 0);

}  // namespace abflat
