#include "solve/cholesky/elimination_tree.h"

#include <algorithm>

namespace abflat {
namespace {

std::vector<std::uint32_t> inverse(const std::vector<std::uint32_t>& order) {
  std::vector<std::uint32_t> place(order.size());
  for (std::uint32_t k = 0; k < order.size(); ++k) place[order[k]] = k;
  return place;
}

/// Liu's algorithm with path compression.
std::vector<std::uint32_t> parents(const WeightedGraph& g, const EliminationTree& t) {
  std::vector<std::uint32_t> parent(g.size(), kNoParent), ancestor(g.size(), kNoParent);
  for (std::uint32_t k = 0; k < g.size(); ++k)
    for (const std::uint32_t* u = g.begin(t.order[k]); u != g.end(t.order[k]); ++u)
      for (std::uint32_t i = t.place[*u]; i < k;) {
        const std::uint32_t next = ancestor[i];
        ancestor[i] = k;
        if (next == kNoParent) {
          parent[i] = k;
          break;
        }
        i = next;
      }
  return parent;
}

/// Gilbert, Ng and Peyton: the row subtrees' leaves, found by their first descendants, count as 1
/// and their least common ancestors as -1. Nodes are in postorder; row i counts by its weight.
class ColumnCounts {
 public:
  ColumnCounts(const WeightedGraph& graph, const EliminationTree& tree) : g_(graph), t_(tree) {}

  std::vector<std::uint64_t> run() {
    const std::uint32_t n = g_.size();
    first_.assign(n, kNoParent);
    maxFirst_.assign(n, 0);
    previousLeaf_.assign(n, kNoParent);
    ancestor_.resize(n);
    std::vector<std::int64_t> delta(n, 0);
    for (std::uint32_t j = 0; j < n; ++j) {
      ancestor_[j] = j;
      if (first_[j] == kNoParent) delta[j] = g_.weight[t_.order[j]];
      for (std::uint32_t i = j; i != kNoParent && first_[i] == kNoParent; i = t_.parent[i])
        first_[i] = j;
    }
    for (std::uint32_t j = 0; j < n; ++j) {
      if (t_.parent[j] != kNoParent) delta[t_.parent[j]] -= g_.weight[t_.order[j]];
      for (const std::uint32_t* u = g_.begin(t_.order[j]); u != g_.end(t_.order[j]); ++u) {
        const std::uint32_t i = t_.place[*u];
        if (i <= j || first_[j] + 1 <= maxFirst_[i]) continue;
        maxFirst_[i] = first_[j] + 1;
        delta[j] += g_.weight[*u];
        if (previousLeaf_[i] != kNoParent) delta[root(previousLeaf_[i])] -= g_.weight[*u];
        previousLeaf_[i] = j;
      }
      if (t_.parent[j] != kNoParent) ancestor_[j] = t_.parent[j];
    }
    for (std::uint32_t j = 0; j < n; ++j)
      if (t_.parent[j] != kNoParent) delta[t_.parent[j]] += delta[j];
    return {delta.begin(), delta.end()};
  }

 private:
  std::uint32_t root(std::uint32_t i) {
    std::uint32_t r = i;
    while (ancestor_[r] != r) r = ancestor_[r];
    while (ancestor_[i] != r) {
      const std::uint32_t next = ancestor_[i];
      ancestor_[i] = r;
      i = next;
    }
    return r;
  }

  const WeightedGraph& g_;
  const EliminationTree& t_;
  std::vector<std::uint32_t> first_;         ///< descendant that comes first in the postorder
  std::vector<std::uint32_t> maxFirst_;      ///< 1 + largest first_ of row i's leaves so far
  std::vector<std::uint32_t> previousLeaf_;  ///< of row i's subtree
  std::vector<std::uint32_t> ancestor_;
};

}  // namespace

std::vector<std::uint32_t> postorder(const std::vector<std::uint32_t>& parent) {
  const auto n = static_cast<std::uint32_t>(parent.size());
  std::vector<std::uint32_t> firstChild(n, kNoParent), nextSibling(n, kNoParent), result, stack;
  for (std::uint32_t j = n; j-- > 0;) {
    if (parent[j] == kNoParent) continue;
    nextSibling[j] = firstChild[parent[j]];
    firstChild[parent[j]] = j;
  }
  result.reserve(n);
  for (std::uint32_t root = 0; root < n; ++root) {
    if (parent[root] != kNoParent) continue;
    stack.push_back(root);
    while (!stack.empty()) {
      const std::uint32_t j = stack.back(), child = firstChild[j];
      if (child == kNoParent) {
        result.push_back(j);
        stack.pop_back();
      } else {
        firstChild[j] = nextSibling[child];
        stack.push_back(child);
      }
    }
  }
  return result;
}

EliminationTree eliminationTree(const WeightedGraph& graph, std::vector<std::uint32_t> order) {
  EliminationTree t;
  t.order = std::move(order);
  t.place = inverse(t.order);
  const std::vector<std::uint32_t> parent = parents(graph, t);
  const std::vector<std::uint32_t> post = postorder(parent), number = inverse(post);
  std::vector<std::uint32_t> renumbered(graph.size());
  t.parent.resize(graph.size());
  for (std::uint32_t k = 0; k < graph.size(); ++k) {
    renumbered[k] = t.order[post[k]];
    t.parent[k] = parent[post[k]] == kNoParent ? kNoParent : number[parent[post[k]]];
  }
  t.order = std::move(renumbered);
  t.place = inverse(t.order);
  t.count = ColumnCounts(graph, t).run();
  return t;
}

}  // namespace abflat
