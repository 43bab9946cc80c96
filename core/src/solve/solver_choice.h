#pragma once

#include <functional>
#include <memory>

#include "abflat/generated/flatten_options.h"
#include "solve/newton_step_solver.h"

namespace abflat {

/// How the linear systems of Newton's method are solved.
struct SolverChoice {
  LinearSolver solver = LinearSolver::Schur;
  Formulation formulation = Formulation::Log;
  /// Makes the solver for the steps of the active set; empty: elimination.
  std::function<std::unique_ptr<NewtonStepSolver>(const AngleProblem&)> make;
};

}  // namespace abflat
