#pragma once

#include "solve/multigrid/half_matrix.h"

namespace abflat {

/// The large entries of a matrix between rows of the same kind. Dropped entries are added to the
/// diagonal, which keeps the row sums within each kind.
struct StrongGraph {
  CompressedRows off;  ///< off the diagonal, both triangles
  std::vector<double> diagonal;
};

/// An entry is strong if it is at least `share` of the largest of its kind in its row or in its
/// column. `kind` has one entry per row. Rows whose diagonal dominates get no entries.
StrongGraph strongGraph(const HalfMatrix& a, const std::vector<std::uint8_t>& kind, double share);

constexpr std::uint32_t kNoAggregate = 0xffffffffu;

/// Disjoint clusters of strongly connected rows: a coarse row each.
struct Aggregates {
  std::vector<std::uint32_t> ofRow;  ///< kNoAggregate: the row has no strong entries
  std::vector<std::uint8_t> kind;    ///< per aggregate
  std::uint32_t count() const { return static_cast<std::uint32_t>(kind.size()); }
};
Aggregates aggregate(const StrongGraph& graph, const std::vector<std::uint8_t>& kind);

/// Smoothed aggregation (Vanek, Mandel and Brezina 1996): constants on the aggregates after a
/// damped Jacobi step with the strong part of the matrix. One row per row of the matrix.
CompressedRows smoothedProlongation(const StrongGraph& graph, const Aggregates& aggregates);

}  // namespace abflat
