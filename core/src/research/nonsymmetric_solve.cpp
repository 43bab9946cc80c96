#include "research/nonsymmetric_solve.h"

#include <Eigen/IterativeLinearSolvers>
#include <algorithm>
#include <unsupported/Eigen/IterativeSolvers>

namespace abflat {
namespace {

/// Vectors that GMRES keeps. Small systems have no more rows than that, so it ends as the theory
/// says.
constexpr Eigen::Index kFewestKept = 100, kSmallSystem = 400;

/// A LinearOperator in the form in which Eigen's solvers expect their preconditioners.
class Preconditioner {
 public:
  void set(const LinearOperator& apply) { apply_ = apply; }
  template <class Matrix>
  Preconditioner& analyzePattern(const Matrix&) {
    return *this;
  }
  template <class Matrix>
  Preconditioner& factorize(const Matrix&) {
    return *this;
  }
  template <class Matrix>
  Preconditioner& compute(const Matrix&) {
    return *this;
  }
  template <class Rhs>
  Eigen::VectorXd solve(const Rhs& b) const {
    if (!apply_) return b;
    Eigen::VectorXd out(b.size());
    apply_(b, out);
    return out;
  }
  Eigen::ComputationInfo info() const { return Eigen::Success; }

 private:
  LinearOperator apply_;
};

template <class Solver>
LinearSolveResult run(Solver& solver, const Eigen::SparseMatrix<double>& matrix,
                      const Eigen::VectorXd& rhs, const LinearSolveOptions& options,
                      const LinearOperator& preconditioner, const Eigen::VectorXd& guess) {
  solver.preconditioner().set(preconditioner);
  solver.setTolerance(options.tolerance);
  solver.setMaxIterations(options.maxIterations);
  solver.compute(matrix);
  LinearSolveResult out;
  out.x = solver.solveWithGuess(rhs, guess);
  out.iterations = static_cast<int>(solver.iterations());
  const double norm = rhs.norm();
  out.residual = norm > 0 ? (matrix * out.x - rhs).norm() / norm : 0;
  out.converged = solver.info() == Eigen::Success;
  return out;
}

}  // namespace

LinearSolveResult gmres(const Eigen::SparseMatrix<double>& matrix, const Eigen::VectorXd& rhs,
                        const LinearSolveOptions& options, const LinearOperator& preconditioner) {
  Eigen::GMRES<Eigen::SparseMatrix<double>, Preconditioner> solver;
  solver.set_restart(static_cast<int>(rhs.size() <= kSmallSystem ? std::max(rhs.size(), kFewestKept)
                                                                 : kFewestKept));
  return run(solver, matrix, rhs, options, preconditioner, Eigen::VectorXd::Zero(rhs.size()));
}

LinearSolveResult bicgstab(const Eigen::SparseMatrix<double>& matrix, const Eigen::VectorXd& rhs,
                           const LinearSolveOptions& options,
                           const LinearOperator& preconditioner) {
  Eigen::BiCGSTAB<Eigen::SparseMatrix<double>, Preconditioner> solver;
  // Starting from 0 it breaks down at once if only constraints are violated: their block is empty,
  // so that r^T A r = 0.
  Eigen::VectorXd guess = rhs;
  if (preconditioner) preconditioner(rhs, guess);
  return run(solver, matrix, rhs, options, preconditioner, guess);
}

}  // namespace abflat
