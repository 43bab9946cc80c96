#pragma once

#include <vector>

#include "solve/sparse_system.h"

namespace abflat {

/// Solutions for all right-hand sides, by Cholesky on the normal equations of rows scaled to a
/// diagonal of 1, refined until the residual stops falling. The diagonal is positive. Empty if that
/// fails: the matrix is singular, or nearly so.
std::vector<double> solveGeneral(const SparseSystem& system);

}  // namespace abflat
