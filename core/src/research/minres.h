#pragma once

#include "research/linear_solve.h"

namespace abflat {

/// Paige and Saunders 1975: minimises the residual over the Krylov space. The matrix is symmetric
/// and may be indefinite, or singular if the system is consistent. `preconditioner` applies the
/// inverse of a symmetric positive definite matrix; empty for none.
LinearSolveResult minres(const LinearOperator& matrix, const Eigen::VectorXd& rhs,
                         const LinearSolveOptions& options,
                         const LinearOperator& preconditioner = {});

}  // namespace abflat
