#pragma once

#include "research/linear_solve.h"

namespace abflat {

/// Paige and Saunders 1975: the LQ factors of the Lanczos matrix, ending at the Galerkin point
/// where its residual is the smaller one. The matrix is symmetric and may be indefinite, but not
/// singular. `preconditioner` applies the inverse of a symmetric positive definite matrix; empty
/// for none.
LinearSolveResult symmlq(const LinearOperator& matrix, const Eigen::VectorXd& rhs,
                         const LinearSolveOptions& options,
                         const LinearOperator& preconditioner = {});

}  // namespace abflat
