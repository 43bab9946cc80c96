#pragma once

#include "solve/cholesky/graph.h"

namespace abflat {

constexpr std::uint32_t kNoParent = 0xffffffffu;

/// The elimination tree of a graph whose vertices are renumbered in postorder, so that every
/// subtree is a range of numbers that ends with its root.
struct EliminationTree {
  std::vector<std::uint32_t> order;   ///< entry k is the vertex eliminated k-th
  std::vector<std::uint32_t> place;   ///< inverse of `order`
  std::vector<std::uint32_t> parent;  ///< by place; kNoParent at a root
  std::vector<std::uint64_t> count;   ///< by place: weight of the column of the factor, with itself
};

/// `order` is any elimination order; the result's is an equivalent one.
EliminationTree eliminationTree(const WeightedGraph& graph, std::vector<std::uint32_t> order);

/// Children before parents, siblings in the order of their numbers. Entry k is the k-th node.
std::vector<std::uint32_t> postorder(const std::vector<std::uint32_t>& parent);

}  // namespace abflat
