#pragma once

#include "abflat/flatten.h"

namespace abflat {

/// True for the solvers that factor the matrix of the vertex constraints alone.
inline bool isEliminated(LinearSolver solver) {
  return solver == LinearSolver::Schur || solver == LinearSolver::Eigen;
}

/// What the explicit KKT system is made of and solved with.
struct KktOptions {
  LinearSolver solver = LinearSolver::Minres;  ///< any that is not eliminated
  Formulation formulation = Formulation::Log;
  bool precondition = true;
  double tolerance = 1e-11;   ///< of the linear residual, relative
  int maxIterations = 20000;  ///< and not more than rows call for
};

}  // namespace abflat
