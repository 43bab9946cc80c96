#pragma once

#include <Eigen/SparseCore>

namespace abflat {

/// Solutions for the columns of `b`, by Cholesky on the normal equations of rows scaled to a
/// diagonal of 1, refined until the residual stops falling. `m` is square with a positive diagonal.
/// Empty if that fails: m is singular, or nearly so.
Eigen::MatrixXd solveGeneral(const Eigen::SparseMatrix<double>& m, const Eigen::MatrixXd& b);

}  // namespace abflat
