#include <Eigen/OrderingMethods>
#include <algorithm>
#include <numeric>

#include "catch.h"
#include "solve/cholesky/coarsen.h"
#include "solve/cholesky/matrices.h"
#include "solve/cholesky/separator.h"
#include "support/meshes.h"

using namespace abflat;
using namespace abflat::test;

namespace {

bool isPermutation(std::vector<std::uint32_t> order, std::size_t n) {
  std::sort(order.begin(), order.end());
  std::vector<std::uint32_t> wanted(n);
  std::iota(wanted.begin(), wanted.end(), 0u);
  return order == wanted;
}

WeightedGraph graphOf(const SparseMatrix& m) { return compressGraph(patternOf(m)).graph; }

/// Entries of the factor for an order, found by symbolically eliminating the whole matrix.
std::vector<std::uint64_t> columnCountsByElimination(const WeightedGraph& g,
                                                     const std::vector<std::uint32_t>& order) {
  std::vector<std::uint32_t> place(g.size());
  for (std::uint32_t k = 0; k < g.size(); ++k) place[order[k]] = k;
  std::vector<std::vector<std::uint8_t>> filled(g.size(), std::vector<std::uint8_t>(g.size(), 0));
  for (std::uint32_t v = 0; v < g.size(); ++v)
    for (const std::uint32_t* u = g.begin(v); u != g.end(v); ++u) filled[place[v]][place[*u]] = 1;
  std::vector<std::uint64_t> count(g.size());
  for (std::uint32_t k = 0; k < g.size(); ++k) {
    count[k] = g.weight[order[k]];
    for (std::uint32_t i = k + 1; i < g.size(); ++i) {
      if (!filled[k][i]) continue;
      count[k] += g.weight[order[i]];
      for (std::uint32_t j = k + 1; j < g.size(); ++j)
        if (j != i && filled[k][j]) filled[i][j] = 1;
    }
  }
  return count;
}

}  // namespace

TEST_CASE("rows of equal structure become one vertex, others do not", "[cholesky]") {
  for (const NamedGraph& named : awkwardGraphs()) {
    INFO(named.name);
    const SparseMatrix m = graphLaplacian(named.size, named.edges, 1, 1);
    const CompressedGraph once = compressGraph(patternOf(m));
    const SparseMatrix two = withTwoRowsEach(m);
    const CompressedGraph twice = compressGraph(patternOf(two));
    CHECK(once.graph.neighbour == twice.graph.neighbour);
    CHECK(once.graph.size() == twice.graph.size());
    for (std::uint32_t v = 0; v < once.graph.size(); ++v)
      CHECK(2 * once.graph.weight[v] == twice.graph.weight[v]);
    // The pattern of the vertices spells out that of the matrix.
    std::vector<std::uint32_t> vertexOf(static_cast<std::size_t>(m.rows()));
    for (std::uint32_t v = 0; v < once.graph.size(); ++v)
      for (std::uint32_t r = once.firstRow[v]; r < once.firstRow[v + 1]; ++r) vertexOf[r] = v;
    std::uint64_t entries = 0;
    for (std::uint32_t v = 0; v < once.graph.size(); ++v) {
      std::uint64_t neighbours = once.graph.weight[v] + 1;
      for (const std::uint32_t* u = once.graph.begin(v); u != once.graph.end(v); ++u)
        neighbours += once.graph.weight[*u];
      entries += once.graph.weight[v] * neighbours;
    }
    CHECK(entries == 2 * static_cast<std::uint64_t>(m.nonZeros()));
  }
}

TEST_CASE("separators separate, and their weights add up", "[cholesky]") {
  std::vector<WeightedGraph> graphs;
  for (const NamedGraph& named : awkwardGraphs())
    if (named.size > 0) graphs.push_back(graphOf(graphLaplacian(named.size, named.edges, 1, 1)));
  graphs.push_back(graphOf(meshLaplacian(bumpyGrid(60, 40, 0.3, 1))));
  graphs.push_back(graphOf(meshLaplacian(torus(50, 30))));
  for (const WeightedGraph& g : graphs) {
    const Separation s = separate(g);
    REQUIRE(s.set.size() == g.size());
    std::array<std::uint64_t, 3> weight{};
    bool touching = false;
    for (std::uint32_t v = 0; v < g.size(); ++v) {
      weight[s.set[v]] += g.weight[v];
      for (const std::uint32_t* u = g.begin(v); u != g.end(v); ++u)
        touching |= s.set[v] + s.set[*u] == 1;
    }
    CHECK_FALSE(touching);
    CHECK(weight == s.weight);
  }
}

TEST_CASE("separators of grids are short and balanced", "[cholesky]") {
  for (const auto& [columns, rows] :
       {std::pair{100u, 30u}, {64u, 64u}, {30u, 200u}, {150u, 120u}}) {
    const WeightedGraph g = graphOf(meshLaplacian(bumpyGrid(columns, rows, 0.3, 2)));
    const Separation s = separate(g);
    CHECK(static_cast<double>(s.weight[2]) <= 1.3 * (std::min(columns, rows) + 1));
    CHECK(static_cast<double>(std::max(s.weight[0], s.weight[1])) <= 0.62 * g.size());
  }
}

TEST_CASE("coarse graphs keep weights and connections", "[cholesky]") {
  const WeightedGraph g = graphOf(meshLaplacian(bumpyGrid(40, 40, 0.3, 3)));
  const CoarseGraph c = coarsen(g, {});
  CHECK(c.graph.size() < g.size() / 2);
  std::vector<std::uint32_t> weight(c.graph.size(), 0);
  std::uint64_t across = 0, sum = 0;
  for (std::uint32_t v = 0; v < g.size(); ++v) {
    weight[c.cluster[v]] += g.weight[v];
    for (const std::uint32_t* u = g.begin(v); u != g.end(v); ++u)
      across += c.cluster[v] != c.cluster[*u];
  }
  for (const std::uint32_t w : c.edgeWeight) sum += w;
  CHECK(weight == c.graph.weight);
  CHECK(across == sum);
}

TEST_CASE("orders are permutations and column counts those of an elimination", "[cholesky]") {
  for (const NamedGraph& named : awkwardGraphs()) {
    INFO(named.name);
    const WeightedGraph g = graphOf(graphLaplacian(named.size, named.edges, 1, 1));
    for (const std::uint32_t leaf : {1u, 20u, 100u}) {
      const std::vector<std::uint32_t> order = nestedDissection(g, {leaf});
      REQUIRE(isPermutation(order, g.size()));
      const EliminationTree t = eliminationTree(g, order);
      REQUIRE(isPermutation(t.order, g.size()));
      if (g.size() <= 400) CHECK(t.count == columnCountsByElimination(g, t.order));
      for (std::uint32_t k = 0; k < g.size(); ++k)
        REQUIRE((t.parent[k] == kNoParent || t.parent[k] > k));
    }
  }
}

TEST_CASE("nested dissection fills about as little as minimum degree on a grid", "[cholesky]") {
  const SparseMatrix m = meshLaplacian(bumpyGrid(200, 200, 0.3, 4));
  const WeightedGraph g = graphOf(m);
  const auto entries = [&](const std::vector<std::uint32_t>& order) {
    const EliminationTree t = eliminationTree(g, order);
    return std::accumulate(t.count.begin(), t.count.end(), std::uint64_t{0});
  };
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> amd;
  Eigen::AMDOrdering<int>()(m.selfadjointView<Eigen::Lower>(), amd);
  const std::vector<std::uint32_t> byDegree(amd.indices().begin(), amd.indices().end());
  CHECK(static_cast<double>(entries(nestedDissection(g, {}))) <
        1.1 * static_cast<double>(entries(byDegree)));
}
