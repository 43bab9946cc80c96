#include "solve/cholesky/symbolic.h"

#include <algorithm>

#include "base/stable_order.h"

namespace abflat {
namespace {

/// Converts places of vertices to places of rows.
void expandRows(const CompressedGraph& c, const Supernodes& s, CholeskySymbolic& out) {
  const std::vector<std::uint32_t>& weight = c.graph.weight;
  std::vector<std::uint32_t> firstRow(1, 0);
  out.eliminationRank.resize(out.size);
  for (const std::uint32_t v : s.order) {
    for (std::uint32_t r = 0; r < weight[v]; ++r)
      out.eliminationRank[c.firstRow[v] + r] = firstRow.back() + r;
    firstRow.push_back(firstRow.back() + weight[v]);
  }
  for (const std::uint32_t f : s.first) out.firstColumn.push_back(firstRow[f]);
  out.rowsBegin.push_back(0);
  for (std::uint32_t p = 0; p < s.size(); ++p) {
    for (std::size_t i = s.rowsBegin[p]; i < s.rowsBegin[p + 1]; ++i)
      for (std::uint32_t r = firstRow[s.rows[i]]; r < firstRow[s.rows[i] + 1]; ++r)
        out.rows.push_back(r);
    out.rowsBegin.push_back(out.rows.size());
  }
  out.parent = s.parent;
}

void numberInParents(CholeskySymbolic& s) {
  s.inParent.resize(s.rows.size());
  for (std::uint32_t c = 0; c < s.supernodes(); ++c) {
    const std::uint32_t p = s.parent[c];
    if (p == kNoParent) continue;
    const std::uint32_t* row = s.rows.data() + s.rowsBegin[p];
    std::uint32_t below = 0;
    for (std::size_t i = s.rowsBegin[c]; i < s.rowsBegin[c + 1]; ++i) {
      if (s.rows[i] < s.firstColumn[p + 1]) {
        s.inParent[i] = s.rows[i] - s.firstColumn[p];
        continue;
      }
      while (row[below] != s.rows[i]) ++below;
      s.inParent[i] = s.columns(p) + below;
    }
  }
}

/// Computes sizes and work. The update matrices of a supernode and of its children lie in different
/// stacks, so that each stack grows and shrinks only at its end.
void measure(CholeskySymbolic& s) {
  s.panelBegin.assign(1, 0);
  s.stack.assign(s.supernodes(), 0);
  for (std::uint32_t p = s.supernodes(); p-- > 0;)
    if (s.parent[p] != kNoParent) s.stack[p] = !s.stack[s.parent[p]];
  SupernodeSizes sizes;
  for (std::uint32_t p = 0; p < s.supernodes(); ++p) {
    const std::size_t columns = s.columns(p), below = s.rowsBelow(p), rows = columns + below;
    s.panelBegin.push_back(s.panelBegin.back() + rows * columns);
    s.factorEntries += rows * columns - columns * (columns - 1) / 2;
    double flops = 0;
    for (std::size_t j = 0; j < columns; ++j)
      flops += static_cast<double>(rows - j) * static_cast<double>(rows - j);
    s.flops += flops;
    s.maxFrontRows = std::max(s.maxFrontRows, static_cast<std::uint32_t>(rows));
    sizes.update.push_back(below * below);
    sizes.flops.push_back(flops);
  }
  s.tasks = divideIntoTasks(s.parent, s.stack, sizes);
}

/// Finds where each entry of the matrix is added.
void placeEntries(const LowerPattern& pattern, ThreadPool* pool, CholeskySymbolic& s) {
  std::vector<std::uint32_t> supernodeOf(s.size);
  for (std::uint32_t p = 0; p < s.supernodes(); ++p)
    std::fill(supernodeOf.begin() + s.firstColumn[p], supernodeOf.begin() + s.firstColumn[p + 1],
              p);
  const auto forEach = [&](auto&& visit) {
    for (std::uint32_t c = 0; c < s.size; ++c)
      for (int k = pattern.columnStart[c]; k < pattern.columnStart[c + 1]; ++k) {
        const auto r = static_cast<std::uint32_t>(pattern.row[k]);
        if (r < c) continue;
        const std::uint32_t a = s.eliminationRank[r], b = s.eliminationRank[c];
        visit(static_cast<std::uint32_t>(k), std::max(a, b), std::min(a, b));
      }
  };
  s.entriesBegin.assign(s.supernodes() + 1, 0);
  forEach([&](std::uint32_t, std::uint32_t, std::uint32_t column) {
    ++s.entriesBegin[supernodeOf[column] + 1];
  });
  for (std::uint32_t p = 0; p < s.supernodes(); ++p) s.entriesBegin[p + 1] += s.entriesBegin[p];
  s.entries.resize(s.entriesBegin.back());
  beat(pool, s.entries.size());
  struct Position {
    std::uint32_t row, column;
  };
  std::vector<Position> position(s.entries.size());
  std::vector<std::size_t> fill(s.entriesBegin.begin(), s.entriesBegin.end() - 1);
  forEach([&](std::uint32_t source, std::uint32_t row, std::uint32_t column) {
    const std::size_t i = fill[supernodeOf[column]]++;
    s.entries[i].source = source;
    position[i] = {row, column};
  });
  beat(pool, s.entries.size());
  Spares<std::vector<std::uint32_t>> spares;
  parallelRanges(pool, s.supernodes(), 1000, [&](std::size_t begin, std::size_t end) {
    std::unique_ptr<std::vector<std::uint32_t>> spare = spares.take();
    if (!spare) spare = std::make_unique<std::vector<std::uint32_t>>(s.size);
    std::vector<std::uint32_t>& inFront = *spare;
    for (auto p = static_cast<std::uint32_t>(begin); p < end; ++p) {
      const std::uint32_t columns = s.columns(p), front = columns + s.rowsBelow(p);
      for (std::uint32_t j = 0; j < columns; ++j) inFront[s.firstColumn[p] + j] = j;
      for (std::uint32_t i = columns; i < front; ++i)
        inFront[s.rows[s.rowsBegin[p] + i - columns]] = i;
      for (std::size_t i = s.entriesBegin[p]; i < s.entriesBegin[p + 1]; ++i)
        s.entries[i].target =
            inFront[position[i].row] + (position[i].column - s.firstColumn[p]) * front;
    }
    spares.give(std::move(spare));
  });
}

std::vector<std::uint32_t> knownOrder(const CompressedGraph& c,
                                      const std::vector<std::uint32_t>& place) {
  return stableOrder(c.graph.size(), [&](std::uint32_t a, std::uint32_t b) {
    return place[c.firstRow[a]] < place[c.firstRow[b]];
  });
}

}  // namespace

CholeskySymbolic analyzePattern(const LowerPattern& pattern,
                                const CholeskyAnalysisOptions& options) {
  CholeskySymbolic s;
  s.size = pattern.rows;
  s.values = pattern.rows ? static_cast<std::uint32_t>(pattern.columnStart[pattern.rows]) : 0;
  const auto endStep = [&] { beat(options.pool, s.values); };
  const CompressedGraph c = compressGraph(pattern);
  endStep();
  const std::vector<std::uint32_t> order =
      options.eliminationRank.empty() ? nestedDissection(c.graph, options.dissection, options.pool)
                                      : knownOrder(c, options.eliminationRank);
  endStep();
  const EliminationTree tree = eliminationTree(c.graph, order);
  endStep();
  const Supernodes supernodes = findSupernodes(c.graph, tree, options.panelCost);
  endStep();
  expandRows(c, supernodes, s);
  endStep();
  numberInParents(s);
  measure(s);
  endStep();
  placeEntries(pattern, options.pool, s);
  return s;
}

}  // namespace abflat
