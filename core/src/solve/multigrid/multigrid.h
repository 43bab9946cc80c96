#pragma once

#include <memory>
#include <vector>

#include "solve/cholesky/cholesky.h"
#include "solve/multigrid/half_matrix.h"
#include "solve/preconditioner.h"

namespace abflat {

struct MultigridOptions {
  std::uint32_t coarsestRows = 1500;  ///< at most this many rows are factored
  double strongShare = 0.25;          ///< see strongGraph
};

/// One V-cycle of algebraic multigrid (smoothed aggregation, symmetric Gauss-Seidel) for a matrix
/// with several unknowns per vertex: rows of the same kind are coarsened together, all kinds are
/// smoothed together. Takes little more memory than the matrix.
class Multigrid : public Preconditioner {
 public:
  /// `kind`: per row, which unknown it belongs to.
  explicit Multigrid(std::vector<std::uint8_t> kind, MultigridOptions options = {});

  /// Refers to the matrix until the next call. False if it turns out not to be positive definite.
  bool setup(const HalfMatrix& matrix);

  /// Requires a successful setup.
  void apply(const double* r, double* z) const override;

  std::uint32_t levels() const { return static_cast<std::uint32_t>(levels_.size()); }
  /// Number of entries of all levels' matrices, relative to the finest.
  double complexity() const;
  /// Memory held between calls, not counting the finest matrix.
  std::uint64_t bytes() const;

 private:
  struct Level {
    CompressedRows owned;  ///< empty on the finest level
    HalfMatrix matrix;
    CompressedRows prolongation;       ///< from the next level; no rows on the coarsest
    std::vector<double> inverse;       ///< of the diagonal
    mutable std::vector<double> work;  ///< a residual
    mutable std::vector<double> x, b;  ///< unused on the finest level
  };

  bool prepareLevel(Level& level) const;
  bool factorCoarsest(const HalfMatrix& matrix);
  void cycle(std::size_t level, const double* b, double* x) const;

  std::vector<std::uint8_t> kind_;
  MultigridOptions options_;
  std::vector<Level> levels_;
  std::unique_ptr<Cholesky> coarsest_;  ///< null: the smoother alone
};

}  // namespace abflat
