#pragma once

#include <memory>
#include <vector>

#include "refine/anchors.h"
#include "refine/extended_matrix.h"
#include "refine/foreseen_contacts.h"
#include "refine/layout_energy.h"
#include "refine/objective.h"
#include "solve/row_solver.h"

namespace abflat {

/// The derivatives of an objective that change with every step; the matrix is kept by the model.
struct Expansion {
  Eigen::VectorXd gradient;
  SparseEntries outline;  ///< Hessian of what holds the outline, lower triangle
};

/// The quadratic model of an objective round a layout, and the solver that minimises it. Its
/// pattern is kept from step to step.
class StepModel {
 public:
  /// Keeps a reference to the options.
  StepModel(const Objective& objective, Anchors anchors, const RefineOptions& options);

  Expansion expand(const Objective& objective, const std::vector<double>& uv,
                   ElementCurvature curvature);

  /// The step to the minimum of the model last expanded, with the springs of `foreseen`, unless
  /// null. `tolerance`: residual, relative to the largest entry of the gradient. False if there is
  /// no minimum.
  bool minimize(const Expansion& at, const ForeseenContacts* foreseen, double tolerance,
                std::vector<double>& step);

  int solves() const { return solves_; }
  const FactorMemory& memory() const { return memory_; }

 private:
  void makeSolver();
  bool isFixedRow(int row) const { return anchors_.isFixed[ChartVertex(row / 2)] != 0; }
  SparseEntries freeOf(SparseEntries entries) const;
  void holdArm(const std::vector<double>& uv);

  Anchors anchors_;
  const RefineOptions& options_;
  std::vector<std::uint32_t> eliminationRank_;  ///< of rows
  RowSystem rows_;
  ExtendedMatrix matrix_;
  FactorMemory memory_;
  std::unique_ptr<RowSolver> solver_;
  int solves_ = 0;
};

}  // namespace abflat
