#pragma once

#include <Eigen/SparseCore>

namespace abflat {

/// Solutions for the columns of `b`, by Cholesky; only the lower triangle of `m` is read. Empty if
/// m is singular.
Eigen::MatrixXd solveSymmetric(const Eigen::SparseMatrix<double>& m, const Eigen::MatrixXd& b);

}  // namespace abflat
