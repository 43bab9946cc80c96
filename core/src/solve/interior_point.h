#pragma once

#include "angle/angle_problem.h"
#include "solve/angle_solution.h"

namespace abflat {

class NewtonSystem;

/// Keeps the smallest angles of a hard chart large enough to be drawn: its exact optimum has angles
/// of 1e-9, while with this floor its layout has no flipped triangle.
constexpr double kDefaultBarrierFloor = 1e-2;

struct InteriorPointOptions {
  SolverOptions common;
  /// The barrier parameter of the angles does not go below this.
  double barrierFloor = kDefaultBarrierFloor;
};

/// Primal-dual interior point on the same element matrices: a barrier on the angles adds z/x to the
/// diagonal Hessian, a slack s of a boundary inequality adds s/mu to the diagonal of its row.
/// Starts from the targets. Slower than the active set, but not stopped by angles that tend to 0.
AngleSolution solveInteriorPoint(const AngleProblem& problem, NewtonSystem& system,
                                 const InteriorPointOptions& options);

}  // namespace abflat
