#include "solve/cholesky/graph.h"

namespace abflat {
namespace {

/// sameAsNext[i]: rows i and i + 1 have the same columns, ignoring the diagonal.
std::vector<std::uint8_t> findEqualRows(const LowerPattern& p) {
  const std::uint32_t n = p.rows;
  std::vector<std::uint32_t> left(n, 0);   // entries of row i left of the diagonal
  std::vector<std::uint32_t> pairs(n, 0);  // columns that hold both row i and row i + 1, below
  std::vector<std::uint8_t> equal(n, 0);
  for (std::uint32_t c = 0; c < n; ++c)
    for (int k = p.columnStart[c]; k < p.columnStart[c + 1]; ++k) {
      const auto i = static_cast<std::uint32_t>(p.row[k]);
      if (i <= c) continue;
      ++left[i];
      if (k + 1 < p.columnStart[c + 1] && p.row[k + 1] == p.row[k] + 1) ++pairs[i];
    }
  const auto below = [&](std::uint32_t c) {
    int k = p.columnStart[c];
    while (k < p.columnStart[c + 1] && p.row[k] <= static_cast<int>(c)) ++k;
    return k;
  };
  for (std::uint32_t i = 0; i + 1 < n; ++i) {
    int a = below(i), b = below(i + 1);
    const int aEnd = p.columnStart[i + 1], bEnd = p.columnStart[i + 2];
    if (a == aEnd || p.row[a] != static_cast<int>(i + 1)) continue;
    if (left[i] != pairs[i] || left[i + 1] != left[i] + 1 || aEnd - a - 1 != bEnd - b) continue;
    for (++a; a < aEnd && p.row[a] == p.row[b]; ++a) ++b;
    equal[i] = a == aEnd;
  }
  return equal;
}

}  // namespace

CompressedGraph compressGraph(const LowerPattern& p) {
  CompressedGraph out;
  const std::vector<std::uint8_t> equal = findEqualRows(p);
  std::vector<std::uint32_t> vertexOfRow(p.rows);
  for (std::uint32_t r = 0; r < p.rows; ++r) {
    if (r == 0 || !equal[r - 1]) out.firstRow.push_back(r);
    vertexOfRow[r] = static_cast<std::uint32_t>(out.firstRow.size() - 1);
  }
  const auto vertices = static_cast<std::uint32_t>(out.firstRow.size());
  out.firstRow.push_back(p.rows);

  WeightedGraph& g = out.graph;
  g.weight.resize(vertices);
  for (std::uint32_t v = 0; v < vertices; ++v) g.weight[v] = out.firstRow[v + 1] - out.firstRow[v];
  const auto forEachEdge = [&](auto&& visit) {
    for (std::uint32_t v = 0; v < vertices; ++v) {
      const std::uint32_t c = out.firstRow[v];
      std::uint32_t last = v;
      for (int k = p.columnStart[c]; k < p.columnStart[c + 1]; ++k) {
        if (p.row[k] <= static_cast<int>(c)) continue;
        const std::uint32_t u = vertexOfRow[static_cast<std::uint32_t>(p.row[k])];
        if (u != last) visit(v, u);
        last = u;
      }
    }
  };
  g.offset.assign(vertices + 1, 0);
  forEachEdge([&](std::uint32_t a, std::uint32_t b) { ++g.offset[a + 1], ++g.offset[b + 1]; });
  for (std::uint32_t v = 0; v < vertices; ++v) g.offset[v + 1] += g.offset[v];
  g.neighbour.resize(g.offset.back());
  std::vector<std::size_t> fill(g.offset.begin(), g.offset.end() - 1);
  forEachEdge([&](std::uint32_t a, std::uint32_t b) { g.neighbour[fill[b]++] = a; });
  forEachEdge([&](std::uint32_t a, std::uint32_t b) { g.neighbour[fill[a]++] = b; });
  return out;
}

}  // namespace abflat
