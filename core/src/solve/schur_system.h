#pragma once

#include <Eigen/SparseCore>
#include <cstdint>
#include <vector>

#include "base/parallel.h"
#include "solve/linearization.h"
#include "solve/row_system.h"

namespace abflat {

/// The Newton system (8) with all angles and triangle constraints eliminated triangle by triangle:
/// symmetric positive semidefinite, one row per vertex constraint.
class SchurSystem {
 public:
  /// `pool`: null for one thread.
  SchurSystem(const AngleProblem& problem, const ConstraintRows& rows, ThreadPool* pool = nullptr);

  /// See RowSystem.
  void divide(const std::vector<std::uint32_t>& rankOfRow) { system_.divide(rankOfRow); }

  /// Inactive boundary rows become identity rows with right-hand side 0. `active` has one entry per
  /// vertex. `compliance`, unless empty, has one entry >= 0 per vertex that is added to the
  /// diagonal of its boundary row.
  void assemble(const Linearization& lin, const std::vector<std::uint8_t>& active,
                const std::vector<double>& compliance = {});

  /// Lower triangle by columns.
  const Eigen::SparseMatrix<double>& matrix() const { return system_.matrix(); }
  const Eigen::VectorXd& rightHandSide() const { return system_.rightHandSide; }

  /// Computes the step dx of all angles and the triangles' multipliers from the solved row
  /// multipliers.
  void backSubstitute(const Linearization& lin, const std::vector<double>& rowMultipliers,
                      std::vector<double>& dx, std::vector<double>& triangleMultipliers) const;

 private:
  const AngleProblem& problem_;
  const ConstraintRows& rows_;
  ThreadPool* pool_;
  RowSystem system_;
};

}  // namespace abflat
