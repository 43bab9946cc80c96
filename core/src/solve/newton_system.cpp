#include "solve/newton_system.h"

namespace abflat {

NewtonSystem::NewtonSystem(const AngleProblem& problem, LinearSolver solver, ThreadPool* pool)
    : rows_(numberRows(problem)), schur_(problem, rows_, pool) {
  const Eigen::SparseMatrix<double>& m = schur_.matrix();
  if (solver == LinearSolver::Eigen) {
    eigen_ = std::make_unique<EigenFactor>();
    eigen_->analyzePattern(m);
  } else {
    CholeskyAnalysisOptions analysis;
    analysis.pool = pool;
    CholeskyOptions options;
    options.pool = pool;
    cholesky_ = std::make_unique<Cholesky>(
        std::make_shared<const CholeskySymbolic>(
            analyzePattern({rows_.count(), m.outerIndexPtr(), m.innerIndexPtr()}, analysis)),
        options);
    schur_.divide(cholesky_->symbolic().place);
  }
}

bool NewtonSystem::solveRows(std::vector<double>& rows) {
  const Eigen::VectorXd& rhs = schur_.rightHandSide();
  if (eigen_) {
    eigen_->factorize(schur_.matrix());
    if (eigen_->info() != Eigen::Success) return false;
    const Eigen::VectorXd solved = eigen_->solve(rhs);
    rows.assign(solved.begin(), solved.end());
    return true;
  }
  if (!cholesky_->factorize(schur_.matrix().valuePtr()).isOk()) return false;
  rows.assign(rhs.begin(), rhs.end());
  cholesky_->solve(rows.data());
  return true;
}

bool NewtonSystem::solve(const Linearization& lin, const std::vector<std::uint8_t>& active,
                         const std::vector<double>& compliance, std::vector<double>& dx,
                         Multipliers& multipliers) {
  schur_.assemble(lin, active, compliance);
  if (!solveRows(multipliers.row)) return false;
  schur_.backSubstitute(lin, multipliers.row, dx, multipliers.triangle);
  return true;
}

}  // namespace abflat
