#include "solve/angle_solver.h"

#include <limits>

#include "solve/active_set.h"
#include "solve/delaunay_system.h"
#include "solve/interior_point.h"
#include "solve/newton_system.h"

namespace abflat {
namespace {

constexpr int kActiveSetSteps = 30;
constexpr int kDelaunaySteps = 60;
/// Weights grow with each of them, and there is no other method to fall back on.
constexpr int kDelaunayStalledSteps = 6;
constexpr int kInteriorPointSteps = 200;
/// Applies to radians and to the logarithms of lengths round a vertex alike.
constexpr double kRough = 1e-3;

}  // namespace

AngleSolver::AngleSolver(const AngleProblem& problem, SolverOptions options,
                         const SolverChoice& choice)
    : problem_(problem),
      options_(std::move(options)),
      linearSolver_(choice.solver),
      formulation_(choice.formulation),
      system_(choice.solver == LinearSolver::Eigen
                  ? std::make_unique<NewtonSystem>(problem, makeEigenRowSolver, options_.pool)
                  : std::make_unique<NewtonSystem>(problem, options_.allowedBytes, options_.pool)) {
  if (choice.make) chosen_ = choice.make(problem);
}

AngleSolver::~AngleSolver() = default;

const FactorMemory& AngleSolver::memory() const { return system_->memory(); }

IdVector<ChartVertex, std::uint32_t> AngleSolver::eliminationRank() const {
  return system_->eliminationRank();
}

AngleSolution AngleSolver::solve(const AngleSolution* start, bool isRough) {
  AngleSolution s = runActiveSet(start, isRough);
  if (start && !s.converged && !s.isEnded) s = runActiveSet(nullptr, isRough);
  return s.converged || s.isEnded ? s : solveWithFloor(kDefaultBarrierFloor);
}

AngleSolution AngleSolver::runActiveSet(const AngleSolution* start, bool isRough) {
  SolverOptions options = options_;
  options.maxSteps = kActiveSetSteps;
  if (isRough) {
    options.constraintTolerance = kRough;
    options.gradientTolerance = std::numeric_limits<double>::infinity();
  }
  NewtonStepSolver& system = chosen_ ? *chosen_ : *system_;
  AngleSolution s = solveActiveSet(problem_, system, options, start);
  s.linearSolver = linearSolver_;
  s.formulation = formulation_;
  return s;
}

AngleSolution AngleSolver::solveWithFloor(double barrierFloor) {
  InteriorPointOptions options;
  options.common = options_;
  options.common.maxSteps = kInteriorPointSteps;
  options.barrierFloor = barrierFloor;
  return solveInteriorPoint(problem_, *system_, options);
}

AngleSolution AngleSolver::solveDelaunay(const AngleSolution& start) {
  SolverOptions options = options_;
  options.maxSteps = kDelaunaySteps;
  options.stalledSteps = kDelaunayStalledSteps;
  DelaunaySystem system(problem_);
  return solveActiveSet(problem_, system, options, &start);
}

}  // namespace abflat
