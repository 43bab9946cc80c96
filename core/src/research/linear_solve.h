#pragma once

#include <Eigen/Core>
#include <functional>

namespace abflat {

/// out = A in. `out` has the right size already.
using LinearOperator = std::function<void(const Eigen::VectorXd& in, Eigen::VectorXd& out)>;

struct LinearSolveOptions {
  double tolerance = 1e-11;  ///< of the residual relative to the right-hand side
  int maxIterations = 1000;
};

struct LinearSolveResult {
  Eigen::VectorXd x;
  int iterations = 0;
  double residual = 0;  ///< relative, in the norm of the preconditioner
  bool converged = false;
};

}  // namespace abflat
