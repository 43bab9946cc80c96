#pragma once

#include <Eigen/Core>

namespace abflat::test {

// Eigen's decompositions, compiled once: an instrumented one takes as long to compile as a dozen
// other sources.

Eigen::VectorXd denseSolve(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

struct SymmetricEigen {
  Eigen::VectorXd values;   ///< ascending
  Eigen::MatrixXd vectors;  ///< in columns
};
/// Eigenvalues of a symmetric matrix, of which only the lower triangle is read.
SymmetricEigen symmetricEigen(const Eigen::MatrixXd& a);

/// An orthogonal matrix with as many rows as `a`.
Eigen::MatrixXd orthogonal(const Eigen::MatrixXd& a);

}  // namespace abflat::test
