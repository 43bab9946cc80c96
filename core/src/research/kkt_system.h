#pragma once

#include <Eigen/SparseCore>

#include "abflat/generated/flatten_options.h"
#include "solve/newton_step_solver.h"

namespace abflat {

/// The symmetric system (8) written out, both triangles. Unknowns: dx (3F), then the triangles'
/// multipliers (F), then one multiplier per row. Inactive boundary rows are identity rows.
struct KktSystem {
  Eigen::SparseMatrix<double> matrix;
  Eigen::VectorXd rhs;
  /// Per row: derivative of the wheel as it stands in the system divided by that of its logarithm,
  /// at a point that satisfies it; 1 for all other rows.
  std::vector<double> rowScale;
};

KktSystem buildKkt(const NewtonPoint& at, const ConstraintRows& rows, Formulation formulation);

}  // namespace abflat
