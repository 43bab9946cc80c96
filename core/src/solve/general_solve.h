#pragma once

#include <Eigen/SparseCore>

namespace abflat {

/// Solutions for the columns of `b`, by Cholesky on the normal equations of rows that are scaled to
/// a diagonal of 1, refined until the residual falls no more. `m` is square, its diagonal positive.
/// Empty where that fails: m is singular, or nearly.
Eigen::MatrixXd solveGeneral(const Eigen::SparseMatrix<double>& m, const Eigen::MatrixXd& b);

}  // namespace abflat
