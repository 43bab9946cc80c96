#pragma once

#include "base/parallel.h"
#include "solve/cholesky/graph.h"

namespace abflat {

struct DissectionOptions {
  std::uint32_t leafVertices = 200;  ///< parts of at most this size are ordered by minimum degree
};

/// Elimination order of the vertices: entry k is the vertex eliminated k-th. Recursively, the two
/// parts of a separation come before its separator. The same for any number of threads.
std::vector<std::uint32_t> nestedDissection(const WeightedGraph& graph,
                                            const DissectionOptions& options,
                                            ThreadPool* pool = nullptr);

}  // namespace abflat
