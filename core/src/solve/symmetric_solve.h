#pragma once

#include <vector>

#include "solve/sparse_system.h"

namespace abflat {

/// Solutions for all right-hand sides, by Cholesky; only the lower triangle of the matrix is read.
/// Empty if it is singular.
std::vector<double> solveSymmetric(const SparseSystem& system);

}  // namespace abflat
