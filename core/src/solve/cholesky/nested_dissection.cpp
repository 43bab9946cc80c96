#include "solve/cholesky/nested_dissection.h"

#include <algorithm>

#include "solve/cholesky/minimum_degree.h"
#include "solve/cholesky/separator.h"

namespace abflat {
namespace {

/// Larger parts that cannot be separated are ordered by degree alone.
constexpr std::uint32_t kMaxLeaf = 2000;
/// A separator that weighs more than this share of the whole does not help.
constexpr double kUselessSeparator = 0.5;

struct Part {
  WeightedGraph graph;
  std::vector<std::uint32_t> vertex;  ///< of the whole graph
  std::size_t end;                    ///< of its places in the order
};

/// The subgraph of the vertices in one of the sets.
Part extract(const Part& whole, const std::vector<std::uint8_t>& set, std::uint8_t wanted,
             std::vector<std::uint32_t>& number) {
  Part part;
  const WeightedGraph& g = whole.graph;
  number.resize(g.size());
  std::size_t edges = 0;
  for (std::uint32_t v = 0; v < g.size(); ++v)
    if (set[v] == wanted) {
      number[v] = static_cast<std::uint32_t>(part.vertex.size());
      part.vertex.push_back(whole.vertex[v]);
      part.graph.weight.push_back(g.weight[v]);
      edges += g.degree(v);
    }
  part.graph.offset.reserve(part.vertex.size() + 1);
  part.graph.neighbour.reserve(edges);
  part.graph.offset.push_back(0);
  for (std::uint32_t v = 0; v < g.size(); ++v) {
    if (set[v] != wanted) continue;
    for (const std::uint32_t* u = g.begin(v); u != g.end(v); ++u)
      if (set[*u] == wanted) part.graph.neighbour.push_back(number[*u]);
    part.graph.offset.push_back(part.graph.neighbour.size());
  }
  return part;
}

/// Numbers a separator along itself: neighbours in the mesh get neighbouring places, so that
/// the rows that a descendant shares with it come in runs.
void orderAlong(const Part& p, std::vector<std::uint32_t>& result) {
  const WeightedGraph& g = p.graph;
  std::vector<std::uint32_t> byDegree(g.size()), stack;
  for (std::uint32_t v = 0; v < g.size(); ++v) byDegree[v] = v;
  std::stable_sort(byDegree.begin(), byDegree.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return g.degree(a) < g.degree(b); });
  std::vector<std::uint8_t> seen(g.size(), 0);
  for (const std::uint32_t start : byDegree) {
    if (seen[start]) continue;
    stack.assign(1, start);
    while (!stack.empty()) {
      const std::uint32_t v = stack.back();
      stack.pop_back();
      if (seen[v]) continue;
      seen[v] = 1;
      result.push_back(p.vertex[v]);
      for (const std::uint32_t* u = g.begin(v); u != g.end(v); ++u)
        if (!seen[*u]) stack.push_back(*u);
    }
  }
}

}  // namespace

std::vector<std::uint32_t> nestedDissection(const WeightedGraph& graph,
                                            const DissectionOptions& options) {
  std::vector<std::uint32_t> order(graph.size()), number, placed;
  LocalMinimumDegree minimumDegree(graph);
  const auto place = [&](std::size_t end) {
    std::copy(placed.begin(), placed.end(),
              order.begin() + static_cast<std::ptrdiff_t>(end - placed.size()));
  };
  const auto orderLeaf = [&](Part& part) {
    placed = part.vertex;
    if (part.vertex.size() <= kMaxLeaf)
      minimumDegree.order(placed);
    else
      std::stable_sort(placed.begin(), placed.end(), [&](std::uint32_t a, std::uint32_t b) {
        return graph.degree(a) < graph.degree(b);
      });
    place(part.end);
  };
  std::vector<Part> todo(1);
  todo[0].graph = graph;
  todo[0].vertex.resize(graph.size());
  todo[0].end = graph.size();
  for (std::uint32_t v = 0; v < graph.size(); ++v) todo[0].vertex[v] = v;
  while (!todo.empty()) {
    Part whole = std::move(todo.back());
    todo.pop_back();
    if (whole.graph.size() <= options.leafVertices) {
      orderLeaf(whole);
      continue;
    }
    const Separation s = separate(whole.graph);
    const auto total = static_cast<double>(s.weight[0] + s.weight[1] + s.weight[2]);
    if (s.weight[0] == 0 || s.weight[1] == 0 ||
        static_cast<double>(s.weight[2]) > kUselessSeparator * total) {
      orderLeaf(whole);
      continue;
    }
    const Part separator = extract(whole, s.set, 2, number);
    placed.clear();
    orderAlong(separator, placed);
    place(whole.end);
    Part second = extract(whole, s.set, 1, number);
    second.end = whole.end - placed.size();
    Part first = extract(whole, s.set, 0, number);
    first.end = second.end - second.vertex.size();
    todo.push_back(std::move(second));
    todo.push_back(std::move(first));
  }
  return order;
}

}  // namespace abflat
