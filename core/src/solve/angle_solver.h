#pragma once

#include <memory>

#include "angle/angle_problem.h"
#include "solve/angle_solution.h"
#include "solve/factor_memory.h"
#include "solve/solver_choice.h"

namespace abflat {

class NewtonSystem;

/// Tries the active set first; if that stalls, the interior point.
class AngleSolver {
 public:
  /// Keeps a reference to the problem, whose bounds may change between calls.
  AngleSolver(const AngleProblem& problem, SolverOptions options, const SolverChoice& choice = {});
  ~AngleSolver();

  /// `start`: a solution for other bounds to start from, or null. `isRough`: active sets end as
  /// soon as wheels close to a thousandth, which is good enough to start something else from.
  AngleSolution solve(const AngleSolution* start, bool isRough = false);

  /// The interior point with a given floor of its barrier: the higher the floor, the larger the
  /// smallest angle.
  AngleSolution solveWithFloor(double barrierFloor);

  /// The active set alone, for a problem with condition (9). `start` as above.
  AngleSolution solveDelaunay(const AngleSolution& start);

  const FactorMemory& memory() const;
  IdVector<ChartVertex, std::uint32_t> eliminationRank() const;

 private:
  AngleSolution runActiveSet(const AngleSolution* start, bool isRough);

  const AngleProblem& problem_;
  SolverOptions options_;
  LinearSolver linearSolver_;
  Formulation formulation_;
  std::unique_ptr<NewtonSystem> system_;
  std::unique_ptr<NewtonStepSolver> chosen_;  ///< null: elimination
};

}  // namespace abflat
