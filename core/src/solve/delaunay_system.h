#pragma once

#include <vector>

#include "solve/newton_step_solver.h"
#include "solve/row_solver.h"
#include "solve/sparse_assembly.h"

namespace abflat {

/// The Newton system with condition (9): as SchurSystem, with one more row per active edge. Each
/// triangle contributes a 9x9 element matrix (its vertices' six rows and its three edges). The
/// pattern changes with the active rows, so it is analysed anew when they change.
class DelaunaySystem : public NewtonStepSolver {
 public:
  explicit DelaunaySystem(const AngleProblem& problem)
      : problem_(problem), rows_(numberRows(problem)) {}

  const ConstraintRows& rows() const override { return rows_; }
  bool step(const NewtonPoint& at, std::vector<double>& dx, Multipliers& next) override;

 private:
  using Flags = std::vector<std::uint8_t>;
  using LocalRows = std::array<std::uint32_t, 9>;

  void numberEdges(const std::vector<std::uint8_t>& activeEdge);
  /// Rows of triangle f in the system; kNone for those that do not exist or are not active.
  LocalRows localRows(const NewtonPoint& at, ChartTriangle f) const;
  void assemble(const NewtonPoint& at);
  void backSubstitute(const NewtonPoint& at, std::vector<double>& dx, Multipliers& next) const;

  const AngleProblem& problem_;
  ConstraintRows rows_;
  std::vector<std::uint32_t> rowOfEdge_;  ///< kNone when inactive
  std::uint32_t count_ = 0;
  SparseEntries entries_;
  Eigen::SparseMatrix<double> matrix_;
  Eigen::VectorXd rhs_;
  std::pair<Flags, Flags> analyzedFor_;  ///< active vertices and edges the pattern belongs to
  std::unique_ptr<RowSolver> solver_;
};

}  // namespace abflat
