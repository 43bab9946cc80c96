#pragma once

#include <memory>

#include "solve/kkt_preconditioner.h"
#include "solve/kkt_system.h"
#include "solve/newton_step_solver.h"

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

/// Newton steps through the explicit KKT system and an iterative solver.
class KktStepSolver : public NewtonStepSolver {
 public:
  KktStepSolver(const AngleProblem& problem, const KktOptions& options);

  const ConstraintRows& rows() const override { return rows_; }
  bool step(const NewtonPoint& at, std::vector<double>& dx, Multipliers& next) override;
  int linearIterations() const override { return iterations_; }

 private:
  KktOptions options_;
  ConstraintRows rows_;
  std::unique_ptr<KktPreconditioner> preconditioner_;
  int iterations_ = 0;
};

}  // namespace abflat
