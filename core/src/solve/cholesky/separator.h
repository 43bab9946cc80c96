#pragma once

#include <array>

#include "base/parallel.h"
#include "solve/cholesky/graph.h"

namespace abflat {

/// Vertices of a graph in three sets: no edge joins part 0 and part 1, set 2 separates them.
struct Separation {
  std::vector<std::uint8_t> set;
  std::array<std::uint64_t, 3> weight{};  ///< sum of the vertices' weights
};

/// Splits the graph into two parts of similar weight and a light separator. Either part may be
/// empty if the graph cannot be split; the separator is empty if the graph is disconnected.
Separation separate(const WeightedGraph& graph, ThreadPool* pool = nullptr);

/// Fiduccia-Mattheyses moves of separator vertices into a part, until no series of moves makes the
/// separator lighter.
void refineSeparator(const WeightedGraph& graph, Separation& separation);

}  // namespace abflat
