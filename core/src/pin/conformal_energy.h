#pragma once

#include <Eigen/SparseCore>
#include <vector>

#include "pin/flat_region.h"

namespace abflat {

/// Twice the conformal energy of Lévy et al., "Least squares conformal maps", 2002, as a quadratic
/// form x^T E x: Dirichlet energy minus uv area, twice each. x has size 2V: all u, then all v.
/// Positive semidefinite; 0 where every triangle has the given angles (radians, size 3F, in
/// (0, pi)).
Eigen::SparseMatrix<double> conformalEnergy(const FlatRegion& region, std::size_t vertices,
                                            const std::vector<double>& angles);

}  // namespace abflat
