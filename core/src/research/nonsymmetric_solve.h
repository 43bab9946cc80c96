#pragma once

#include <Eigen/SparseCore>

#include "research/linear_solve.h"

namespace abflat {

/// Eigen's GMRES and BiCGSTAB behind the same interface as the symmetric solvers.
LinearSolveResult gmres(const Eigen::SparseMatrix<double>& matrix, const Eigen::VectorXd& rhs,
                        const LinearSolveOptions& options,
                        const LinearOperator& preconditioner = {});
LinearSolveResult bicgstab(const Eigen::SparseMatrix<double>& matrix, const Eigen::VectorXd& rhs,
                           const LinearSolveOptions& options,
                           const LinearOperator& preconditioner = {});

}  // namespace abflat
