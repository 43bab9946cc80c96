#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

#include "abflat/generated/flatten_options.h"
#include "abflat/newton_step.h"
#include "base/parallel.h"
#include "solve/linearization.h"

namespace abflat {

/// When a solver may stop, and how it is watched.
struct SolverOptions {
  double constraintTolerance = 1e-10;  ///< radians
  double gradientTolerance = 1e-6;     ///< see gradientResidual
  double objectiveTolerance = 1e-9;    ///< relative change in one step
  int maxSteps = 100;
  /// Bytes that a factor may take; see makeRowSolverWithin.
  std::uint64_t allowedBytes = std::numeric_limits<std::uint64_t>::max();
  int stalledSteps = 2;  ///< the iteration ends after this many tiny steps in a row
  /// Called after each step; false ends the solution.
  std::function<bool(const NewtonStep&)> onStep;
  ThreadPool* pool = nullptr;  ///< results do not depend on it; null: one thread
};

struct AngleSolution {
  LinearSolver linearSolver = LinearSolver::Schur;
  Formulation formulation = Formulation::Log;
  std::vector<double> angles;  ///< x, each in (0, pi), size 3F
  Multipliers multipliers;
  std::vector<double> weight;            ///< as used, size 3F; empty: those of the problem
  std::vector<std::uint8_t> active;      ///< per vertex: boundary vertices held at their bound
  std::vector<std::uint8_t> activeEdge;  ///< per edge of condition (9)
  std::vector<NewtonStep> history;
  double constraintResidual = 0;
  bool converged = false;
  bool isEnded = false;  ///< by onStep
  double barrierFloor =
      0;  ///< 0: by the active set; otherwise by the interior point with this floor
};

}  // namespace abflat
