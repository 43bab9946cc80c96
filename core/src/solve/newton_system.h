#pragma once

#include <memory>
#include <vector>

#include "solve/linearization.h"
#include "solve/newton_step_solver.h"
#include "solve/row_solver.h"
#include "solve/schur_system.h"

namespace abflat {

/// The Newton system of a chart with its symbolic factorisation, which stays valid for all bounds,
/// active sets and solvers.
class NewtonSystem : public NewtonStepSolver {
 public:
  /// Keeps a reference to the problem, of which only the connectivity is used here. `pool`:
  /// null for one thread.
  explicit NewtonSystem(const AngleProblem& problem, MakeRowSolver& makeSolver = makeRowSolver,
                        ThreadPool* pool = nullptr);
  /// The factor may take at most `allowedBytes`; doing without it takes longer but little memory.
  NewtonSystem(const AngleProblem& problem, std::uint64_t allowedBytes, ThreadPool* pool = nullptr);
  NewtonSystem(const NewtonSystem&) = delete;
  NewtonSystem& operator=(const NewtonSystem&) = delete;

  const ConstraintRows& rows() const override { return rows_; }
  /// Needs are 0 bytes if no limit was given.
  const FactorMemory& memory() const { return memory_; }
  /// See DiskChart; empty if there is none.
  IdVector<ChartVertex, std::uint32_t> eliminationRank() const;

  bool step(const NewtonPoint& at, std::vector<double>& dx, Multipliers& next) override;
  int linearIterations() const override { return solver_->iterations(); }

  /// One step of eq. (8): the change dx of the angles and the new multipliers. For `compliance` see
  /// SchurSystem::assemble. False if the matrix cannot be factored.
  bool solve(const Linearization& lin, const std::vector<std::uint8_t>& active,
             const std::vector<double>& compliance, std::vector<double>& dx,
             Multipliers& multipliers);

 private:
  ConstraintRows rows_;
  SchurSystem schur_;
  FactorMemory memory_;
  std::unique_ptr<RowSolver> solver_;
  Eigen::VectorXd x_;  ///< multipliers of the rows
};

}  // namespace abflat
