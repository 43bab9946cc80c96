#pragma once

#include "solve/cholesky/elimination_tree.h"

namespace abflat {

/// Ranges of columns that are factored as one dense panel, in postorder.
struct Supernodes {
  std::vector<std::uint32_t> order;    ///< of the graph's vertices: entry k is eliminated k-th
  std::vector<std::uint32_t> first;    ///< supernode s has the places first[s] to first[s+1]
  std::vector<std::uint32_t> parent;   ///< supernode; kNoParent at a root
  std::vector<std::size_t> rowsBegin;  ///< size S+1, into `rows`
  std::vector<std::uint32_t> rows;     ///< places below the supernode's own, ascending

  std::uint32_t size() const { return static_cast<std::uint32_t>(parent.size()); }
};

/// What a panel costs, in units of one multiply-add in the dense kernels. Supernodes are joined
/// where that reduces the sum.
struct PanelCost {
  double perPanel = 500;
  double perRow = 60;
  double perUpdateEntry = 2;  ///< of the square that is added to the parent
};

Supernodes findSupernodes(const WeightedGraph& graph, const EliminationTree& tree,
                          const PanelCost& cost);

}  // namespace abflat
