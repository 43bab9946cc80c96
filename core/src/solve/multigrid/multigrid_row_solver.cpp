#include "solve/multigrid/multigrid_row_solver.h"

#include <algorithm>

#include "solve/conjugate_gradients.h"

namespace abflat {
namespace {

constexpr int kMaxIterations = 1000;
/// What rounding leaves of a residual, in units of the right-hand side.
constexpr double kRounding = 1e-14;

}  // namespace

bool MultigridRowSolver::solve(const Eigen::SparseMatrix<double>& lower, const Eigen::VectorXd& b,
                               double tolerance, Eigen::VectorXd& x) {
  iterations_ = 0;
  const HalfMatrix half{static_cast<std::uint32_t>(lower.rows()), lower.outerIndexPtr(),
                        lower.innerIndexPtr(), lower.valuePtr()};
  if (!multigrid_.setup(half)) return false;
  ConjugateGradientsOptions options;
  options.tolerance = std::max(tolerance, kRounding * b.lpNorm<Eigen::Infinity>());
  options.maxIterations = kMaxIterations;
  const ConjugateGradientsResult result = conjugateGradients(lower, b, multigrid_, x, options);
  iterations_ = result.iterations;
  return result.isConverged();
}

}  // namespace abflat
