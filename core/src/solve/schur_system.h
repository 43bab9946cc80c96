#pragma once

#include <Eigen/SparseCore>
#include <cstdint>
#include <vector>

#include "solve/linearization.h"

namespace abflat {

/// The Newton system (8) with all angles and triangle constraints eliminated triangle by triangle:
/// symmetric positive semidefinite, one row per vertex constraint, assembled from 6x6 element
/// matrices into a pattern that never changes.
class SchurSystem {
 public:
  SchurSystem(const AngleProblem& problem, const ConstraintRows& rows);

  /// Inactive boundary rows become identity rows with right-hand side 0. `active` has one entry per
  /// vertex.
  /// `compliance`, where not empty, has one entry >= 0 per vertex that is added to the diagonal of
  /// its boundary row.
  void assemble(const Linearization& lin, const std::vector<std::uint8_t>& active,
                const std::vector<double>& compliance = {});

  /// Lower triangle by columns.
  const Eigen::SparseMatrix<double>& matrix() const { return matrix_; }
  const Eigen::VectorXd& rightHandSide() const { return rhs_; }

  /// From the solved row multipliers: the step dx of all angles and the triangles' multipliers.
  void backSubstitute(const Linearization& lin, const std::vector<double>& rowMultipliers,
                      std::vector<double>& dx, std::vector<double>& triangleMultipliers) const;

 private:
  void buildPattern();
  void buildScatter();

  static constexpr std::uint32_t kDropped = 0xffffffffu;  ///< entry of a row that does not exist

  const AngleProblem& problem_;
  const ConstraintRows& rows_;
  Eigen::SparseMatrix<double> matrix_;
  Eigen::VectorXd rhs_;
  std::vector<std::uint32_t>
      scatter_;  ///< place in the values of each element entry, 21 per triangle
};

}  // namespace abflat
