#pragma once

#include <Eigen/Core>
#include <vector>

#include "angle/angle_problem.h"
#include "solve/linearization.h"

namespace abflat::test {

/// The problem written out again, constraint by constraint and without any elimination, for small
/// meshes only. Constraints come in this order: triangles, then rows as numbered by ConstraintRows.
struct DenseProblem {
  const AngleProblem& problem;
  const ConstraintRows& rows;

  Eigen::VectorXd constraints(const Eigen::VectorXd& x) const;
  double objective(const Eigen::VectorXd& x) const;
  double lagrangian(const Eigen::VectorXd& x, const Eigen::VectorXd& multipliers) const;

  /// By central differences.
  Eigen::MatrixXd jacobian(const Eigen::VectorXd& x) const;
  Eigen::VectorXd gradient(const Eigen::VectorXd& x, const Eigen::VectorXd& multipliers) const;
};

}  // namespace abflat::test
