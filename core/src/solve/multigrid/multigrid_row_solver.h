#pragma once

#include "solve/multigrid/multigrid.h"
#include "solve/row_solver.h"

namespace abflat {

/// Conjugate gradients with a multigrid cycle: no factor, about the memory of the matrix. Fails
/// on matrices that are not positive definite.
class MultigridRowSolver : public RowSolver {
 public:
  /// `kind`: see Multigrid.
  explicit MultigridRowSolver(std::vector<std::uint8_t> kind) : multigrid_(std::move(kind)) {}

  bool solve(const Eigen::SparseMatrix<double>& lower, const Eigen::VectorXd& b, double tolerance,
             Eigen::VectorXd& x) override;
  int iterations() const override { return iterations_; }

 private:
  Multigrid multigrid_;
  int iterations_ = 0;
};

}  // namespace abflat
