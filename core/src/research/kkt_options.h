#pragma once

#include "abflat/generated/flatten_options.h"

namespace abflat {

/// What the explicit KKT system consists of and how it is solved.
struct KktOptions {
  LinearSolver solver = LinearSolver::Minres;  ///< an iterative one
  Formulation formulation = Formulation::Log;
  bool precondition = true;
  double tolerance = 1e-11;   ///< of the linear residual, relative
  int maxIterations = 20000;  ///< and no more than the number of rows calls for
};

}  // namespace abflat
