#pragma once

#include "solve/cholesky/graph.h"
#include "solve/cholesky/nested_dissection.h"
#include "solve/cholesky/supernodes.h"
#include "solve/cholesky/tasks.h"

namespace abflat {

struct CholeskyAnalysisOptions {
  DissectionOptions dissection;
  PanelCost panelCost;
  /// Per row, its rank in a known elimination order, such as that of a larger matrix; equal ranks
  /// are ordered by row number. Empty: nested dissection finds an order.
  std::vector<std::uint32_t> eliminationRank;
  ThreadPool* pool = nullptr;  ///< results do not depend on it; null: one thread
};

/// Everything that depends on the pattern alone. Several factors may share one; it is never
/// changed. Supernode s owns the columns firstColumn[s] to firstColumn[s+1] of the reordered
/// matrix. Its front has these columns' rows first, then the rows `rows`; its panel is stored by
/// columns.
struct CholeskySymbolic {
  struct Entry {
    std::uint32_t source;  ///< in the values of the matrix
    std::uint32_t target;  ///< in the panel
  };

  std::uint32_t size = 0;
  std::uint32_t values = 0;  ///< entries of the matrix, those above the diagonal included
  std::vector<std::uint32_t> eliminationRank;  ///< row or column of the matrix -> of the factor
  std::vector<std::uint32_t> firstColumn;
  std::vector<std::uint32_t> parent;      ///< kNoParent at a root; supernodes are in postorder
  std::vector<std::size_t> rowsBegin;     ///< size S+1, into `rows` and `inParent`
  std::vector<std::uint32_t> rows;        ///< rows of the factor below the supernode's own
  std::vector<std::uint32_t> inParent;    ///< the same rows, numbered in the parent's front
  std::vector<std::size_t> panelBegin;    ///< size S+1, into the factor's storage
  std::vector<std::size_t> entriesBegin;  ///< size S+1, into `entries`
  std::vector<Entry> entries;
  std::vector<std::uint8_t> stack;  ///< which of the two stacks holds the update matrix
  CholeskyTasks tasks;
  std::uint32_t maxFrontRows = 0;

  std::uint64_t factorEntries = 0;  ///< of the lower triangle, with the zeros of joined columns
  double flops = 0;                 ///< of one factorisation, multiplications and additions
  std::uint32_t supernodes() const { return static_cast<std::uint32_t>(parent.size()); }
  std::uint32_t columns(std::uint32_t s) const { return firstColumn[s + 1] - firstColumn[s]; }
  std::uint32_t rowsBelow(std::uint32_t s) const {
    return static_cast<std::uint32_t>(rowsBegin[s + 1] - rowsBegin[s]);
  }
  /// Memory of a factor while one thread computes it.
  std::uint64_t factorBytes() const {
    return 8 * (static_cast<std::uint64_t>(panelBegin.back()) + tasks.stackSize[0] +
                tasks.stackSize[1] + tasks.maxResults);
  }
};

CholeskySymbolic analyzePattern(const LowerPattern& pattern,
                                const CholeskyAnalysisOptions& options = {});

}  // namespace abflat
