#pragma once

#include <memory>

#include "research/kkt_options.h"
#include "research/kkt_preconditioner.h"
#include "research/kkt_system.h"
#include "solve/newton_step_solver.h"

namespace abflat {

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
