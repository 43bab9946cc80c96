#pragma once

#include <Eigen/SparseCore>
#include <cstdint>
#include <vector>

#include "base/parallel.h"
#include "solve/linearization.h"

namespace abflat {

/// The Newton system (8) with all angles and triangle constraints eliminated triangle by triangle:
/// symmetric positive semidefinite, one row per vertex constraint, assembled from 6x6 element
/// matrices into a pattern that never changes.
class SchurSystem {
 public:
  /// `pool`: null for one thread.
  SchurSystem(const AngleProblem& problem, const ConstraintRows& rows, ThreadPool* pool = nullptr);

  /// Divides the assembly among several threads: each gets rows that are adjacent in the given
  /// elimination order, which keeps regions of the mesh together.
  void divide(const std::vector<std::uint32_t>& rankOfRow);

  /// Inactive boundary rows become identity rows with right-hand side 0. `active` has one entry per
  /// vertex. `compliance`, unless empty, has one entry >= 0 per vertex that is added to the
  /// diagonal of its boundary row.
  void assemble(const Linearization& lin, const std::vector<std::uint8_t>& active,
                const std::vector<double>& compliance = {});

  /// Lower triangle by columns.
  const Eigen::SparseMatrix<double>& matrix() const { return matrix_; }
  const Eigen::VectorXd& rightHandSide() const { return rhs_; }

  /// Computes the step dx of all angles and the triangles' multipliers from the solved row
  /// multipliers.
  void backSubstitute(const Linearization& lin, const std::vector<double>& rowMultipliers,
                      std::vector<double>& dx, std::vector<double>& triangleMultipliers) const;

 private:
  void buildPattern();
  void buildScatter();
  void assembleTriangle(const Linearization& lin, const std::vector<std::uint8_t>& active,
                        ChartTriangle f, std::uint32_t region);
  void assembleBoundary(const std::vector<std::uint8_t>& active,
                        const std::vector<double>& compliance);

  static constexpr std::uint32_t kDropped = 0xffffffffu;  ///< entry of a row that does not exist

  const AngleProblem& problem_;
  const ConstraintRows& rows_;
  ThreadPool* pool_;
  /// The region whose thread fills the vertex's rows; empty: not divided.
  IdVector<ChartVertex, std::uint8_t> regionOfVertex_;
  /// Per region, the triangles that contribute to its rows, ascending: each entry is summed in
  /// triangle order, whichever thread does it.
  std::vector<std::vector<ChartTriangle>> triangles_;
  Eigen::SparseMatrix<double> matrix_;
  Eigen::VectorXd rhs_;
  std::vector<std::uint32_t>
      scatter_;  ///< per element entry, its index in the values; 21 per triangle
};

}  // namespace abflat
