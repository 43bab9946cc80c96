#include "solve/row_solver.h"

#include <Eigen/SparseCholesky>
#include <functional>

#include "solve/cholesky/cholesky.h"
#include "solve/conjugate_gradients.h"
#include "solve/multigrid/multigrid_row_solver.h"

namespace abflat {
namespace {

using SparseMatrix = Eigen::SparseMatrix<double>;
using Symbolic = std::shared_ptr<const CholeskySymbolic>;

/// Per factorisation. Below this, factors are so cheap that iterations do not pay off.
constexpr double kDirectFlops = 4e6;
/// An old factor is kept as long as this many further iterations suffice: they take about as long
/// as a new factor and the few iterations it needs.
constexpr double kWorthwhile = 9;
/// With an old factor as well as with one of the current matrix. Only matrices far beyond what
/// single precision can tell from singular need more.
constexpr int kMaxIterations = 30;

Symbolic analyze(const SparseMatrix& m, ThreadPool* pool,
                 std::vector<std::uint32_t> eliminationRank = {}) {
  CholeskyAnalysisOptions options;
  options.eliminationRank = std::move(eliminationRank);
  options.pool = pool;
  return std::make_shared<const CholeskySymbolic>(analyzePattern(
      {static_cast<std::uint32_t>(m.rows()), m.outerIndexPtr(), m.innerIndexPtr()}, options));
}

CholeskyOptions choleskyOptions(bool allowNegative, ThreadPool* pool) {
  CholeskyOptions options;
  options.allowNegative = allowNegative;
  options.pool = pool;
  return options;
}

class DirectRowSolver : public RowSolver {
 public:
  DirectRowSolver(const Symbolic& symbolic, ThreadPool* pool)
      : factor_(symbolic, choleskyOptions(true, pool)) {}

  const std::vector<std::uint32_t>* eliminationRank() const override {
    return &factor_.symbolic().eliminationRank;
  }

  bool solve(const SparseMatrix& lower, const Eigen::VectorXd& b, double,
             Eigen::VectorXd& x) override {
    if (!factor_.factorize(lower.valuePtr()).isOk()) return false;
    x = b;
    factor_.solve(x.data());
    return true;
  }

 private:
  Cholesky factor_;
};

class FactorPreconditioner : public Preconditioner {
 public:
  explicit FactorPreconditioner(const FloatCholesky& factor) : factor_(factor) {}
  void apply(const double* r, double* z) const override {
    std::copy_n(r, factor_.symbolic().size, z);
    factor_.solve(z);
  }

 private:
  const FloatCholesky& factor_;
};

class InexactRowSolver : public RowSolver {
 public:
  /// `makeExact` makes the solver to use if the iterations do not converge.
  InexactRowSolver(Symbolic symbolic, ThreadPool* pool,
                   std::function<std::unique_ptr<RowSolver>()> makeExact)
      : symbolic_(std::move(symbolic)), pool_(pool), makeExact_(std::move(makeExact)) {}

  const std::vector<std::uint32_t>* eliminationRank() const override {
    return &symbolic_->eliminationRank;
  }

  bool solve(const SparseMatrix& lower, const Eigen::VectorXd& b, double tolerance,
             Eigen::VectorXd& x) override {
    iterations_ = 0;
    if (tolerance > 0) {
      if (factor_ && isNear_ && iterate(lower, b, {tolerance, kMaxIterations, kWorthwhile}, x))
        return true;
      if (refactor(lower) && iterate(lower, b, {tolerance, kMaxIterations}, x)) return true;
    }
    factor_.reset();
    if (!exact_) exact_ = makeExact_();
    const bool isSolved = exact_->solve(lower, b, tolerance, x);
    iterations_ += exact_->iterations();
    return isSolved;
  }

  void forget() override { isNear_ = false; }
  int iterations() const override { return iterations_; }

 private:
  /// False if the matrix is not positive definite in single precision.
  bool refactor(const SparseMatrix& lower) {
    exact_.reset();
    isNear_ = true;
    if (!factor_)
      factor_ = std::make_unique<FloatCholesky>(symbolic_, choleskyOptions(false, pool_));
    return factor_->factorize(lower.valuePtr()).isOk();
  }

  bool iterate(const SparseMatrix& lower, const Eigen::VectorXd& b,
               const ConjugateGradientsOptions& options, Eigen::VectorXd& x) {
    const ConjugateGradientsResult result =
        conjugateGradients(lower, b, FactorPreconditioner(*factor_), x, options);
    iterations_ += result.iterations;
    return result.isConverged();
  }

  Symbolic symbolic_;
  ThreadPool* pool_;
  std::function<std::unique_ptr<RowSolver>()> makeExact_;
  std::unique_ptr<FloatCholesky> factor_;  ///< of this or an earlier matrix
  std::unique_ptr<RowSolver> exact_;       ///< at most one of the two exists
  bool isNear_ = true;                     ///< the factor's matrix is near the next one
  int iterations_ = 0;
};

class EigenRowSolver : public RowSolver {
 public:
  explicit EigenRowSolver(const SparseMatrix& lower) { factor_.analyzePattern(lower); }

  bool solve(const SparseMatrix& lower, const Eigen::VectorXd& b, double,
             Eigen::VectorXd& x) override {
    factor_.factorize(lower);
    if (factor_.info() != Eigen::Success) return false;
    x = factor_.solve(b);
    return true;
  }

 private:
  Eigen::SimplicialLDLT<SparseMatrix> factor_;
};

std::unique_ptr<RowSolver> makeInexact(const Symbolic& symbolic, ThreadPool* pool) {
  return std::make_unique<InexactRowSolver>(
      symbolic, pool, [=] { return std::make_unique<DirectRowSolver>(symbolic, pool); });
}

/// Direct or inexact, whichever is faster.
std::unique_ptr<RowSolver> makeFactorRowSolver(const Symbolic& symbolic, ThreadPool* pool) {
  if (symbolic->flops <= kDirectFlops) return std::make_unique<DirectRowSolver>(symbolic, pool);
  return makeInexact(symbolic, pool);
}

}  // namespace

std::unique_ptr<RowSolver> makeRowSolver(const SparseMatrix& lower, ThreadPool* pool) {
  return makeFactorRowSolver(analyze(lower, pool), pool);
}

std::unique_ptr<RowSolver> makeRowSolverWithin(const SparseMatrix& lower,
                                               std::vector<std::uint8_t> kind, FactorMemory& memory,
                                               ThreadPool* pool,
                                               std::vector<std::uint32_t> eliminationRank) {
  const Symbolic symbolic = analyze(lower, pool, std::move(eliminationRank));
  constexpr std::uint64_t kEntry = sizeof(double) + sizeof(int);
  const std::uint64_t matrix = kEntry * static_cast<std::uint64_t>(lower.nonZeros());
  memory.needed = matrix + symbolic->factorBytes();
  memory.neededInSingle = matrix + symbolic->factorBytes() / 2;
  if (memory.fits()) return makeFactorRowSolver(symbolic, pool);
  const auto withoutFactor = [kind = std::move(kind)] {
    return std::make_unique<MultigridRowSolver>(kind);
  };
  if (memory.fitsInSingle())
    return std::make_unique<InexactRowSolver>(symbolic, pool, withoutFactor);
  return withoutFactor();
}

std::unique_ptr<RowSolver> makeDirectRowSolver(const SparseMatrix& lower, ThreadPool* pool) {
  return std::make_unique<DirectRowSolver>(analyze(lower, pool), pool);
}

std::unique_ptr<RowSolver> makeInexactRowSolver(const SparseMatrix& lower, ThreadPool* pool) {
  return makeInexact(analyze(lower, pool), pool);
}

std::unique_ptr<RowSolver> makeEigenRowSolver(const SparseMatrix& lower, ThreadPool*) {
  return std::make_unique<EigenRowSolver>(lower);
}

}  // namespace abflat
