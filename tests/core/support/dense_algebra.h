#pragma once

#include <Eigen/Core>

namespace abflat::test {

// Eigen's decompositions, compiled once: an instrumented one takes as long as a dozen other
// sources.

Eigen::VectorXd denseSolve(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

struct SymmetricEigen {
  Eigen::VectorXd values;   ///< ascending
  Eigen::MatrixXd vectors;  ///< by columns
};
/// Of a symmetric matrix, of which the lower triangle is read.
SymmetricEigen symmetricEigen(const Eigen::MatrixXd& a);

/// An orthogonal matrix, as many rows as `a` has.
Eigen::MatrixXd orthogonal(const Eigen::MatrixXd& a);

}  // namespace abflat::test
