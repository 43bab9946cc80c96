#pragma once

#include <Eigen/SparseCholesky>
#include <memory>
#include <vector>

#include "abflat/generated/flatten_options.h"
#include "solve/cholesky/cholesky.h"
#include "solve/linearization.h"
#include "solve/newton_step_solver.h"
#include "solve/schur_system.h"

namespace abflat {

/// The Newton system of a chart with its symbolic factorisation, which stays valid for all bounds,
/// active sets and solvers.
class NewtonSystem : public NewtonStepSolver {
 public:
  /// Keeps a reference to the problem, of which only the connectivity is used here. `solver`: Eigen
  /// factors with Eigen's SimplicialLDLT, as the reference; any other with Cholesky. `pool`: null
  /// for one thread.
  explicit NewtonSystem(const AngleProblem& problem, LinearSolver solver = LinearSolver::Schur,
                        ThreadPool* pool = nullptr);
  NewtonSystem(const NewtonSystem&) = delete;
  NewtonSystem& operator=(const NewtonSystem&) = delete;

  const ConstraintRows& rows() const override { return rows_; }

  bool step(const NewtonPoint& at, std::vector<double>& dx, Multipliers& next) override {
    return solve(at.lin, at.active, {}, dx, next);
  }

  /// One step of eq. (8): the change dx of the angles and the new multipliers. For `compliance` see
  /// SchurSystem::assemble. False when the matrix cannot be factored.
  bool solve(const Linearization& lin, const std::vector<std::uint8_t>& active,
             const std::vector<double>& compliance, std::vector<double>& dx,
             Multipliers& multipliers);

 private:
  using EigenFactor = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>;

  bool solveRows(std::vector<double>& rows);

  ConstraintRows rows_;
  SchurSystem schur_;
  std::unique_ptr<Cholesky> cholesky_;  ///< null: Eigen
  std::unique_ptr<EigenFactor> eigen_;  ///< null: Cholesky
};

}  // namespace abflat
