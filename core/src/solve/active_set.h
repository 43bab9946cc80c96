#pragma once

#include "angle/angle_problem.h"
#include "solve/angle_solution.h"
#include "solve/newton_step_solver.h"

namespace abflat {

/// Newton's method with an active set for the boundary's inequalities (paper, section 6), each step
/// through `system`. Starts from the targets, or from `start`, a solution for other
/// bounds. When it does not converge the last iterate is returned with converged = false.
AngleSolution solveActiveSet(const AngleProblem& problem, NewtonStepSolver& system,
                             const SolverOptions& options, const AngleSolution* start = nullptr);

}  // namespace abflat
