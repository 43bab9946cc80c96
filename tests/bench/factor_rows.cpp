#include "factor_rows.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <vector>

#include "solve/cholesky/cholesky.h"
#ifdef ABFLAT_BENCH_CHOLMOD
#include <cholmod.h>
#endif

namespace abflat::bench {
namespace {

template <typename Work>
double seconds(int repeat, Work&& work) {
  std::vector<double> times;
  for (int i = 0; i < repeat; ++i) {
    const auto start = std::chrono::steady_clock::now();
    work();
    times.push_back(
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  std::sort(times.begin(), times.end());
  return times[times.size() / 2];
}

double residual(const SparseMatrix& m, const Eigen::VectorXd& x, const Eigen::VectorXd& b) {
  return (m.selfadjointView<Eigen::Lower>() * x - b).norm() / b.norm();
}

template <typename Factor, bool kStoresDiagonal>
FactorRow runSimplicial(const SparseMatrix& m, const Eigen::VectorXd& b, int repeat) {
  FactorRow row;
  Factor factor;
  Eigen::VectorXd x;
  row.analyze = seconds(1, [&] { factor.analyzePattern(m); });
  row.numeric = seconds(repeat, [&] { factor.factorize(m); });
  row.solve = seconds(repeat, [&] { x = factor.solve(b); });
  const SparseMatrix& l = factor.matrixL().nestedExpression();
  // LDL^T does not store its unit diagonal.
  const auto diagonal = static_cast<double>(factor.matrixL().rows()) * (kStoresDiagonal ? 0 : 1);
  row.entries = static_cast<double>(l.nonZeros()) + diagonal;
  for (int c = 0; c < l.outerSize(); ++c) {
    const double count =
        l.outerIndexPtr()[c + 1] - l.outerIndexPtr()[c] + (kStoresDiagonal ? 0 : 1);
    row.flops += count * count;
  }
  row.residual = residual(m, x, b);
  return row;
}

}  // namespace

FactorRow runOwn(const SparseMatrix& m, const Eigen::VectorXd& b, int repeat,
                 const OwnOptions& own) {
  FactorRow row;
  std::shared_ptr<const CholeskySymbolic> symbolic;
  CholeskyAnalysisOptions analysis;
  analysis.pool = own.pool;
  row.analyze = seconds(repeat, [&] {
    symbolic = std::make_shared<const CholeskySymbolic>(analyzePattern(
        {static_cast<std::uint32_t>(m.rows()), m.outerIndexPtr(), m.innerIndexPtr()}, analysis));
  });
  CholeskyOptions options;
  options.simd = own.width;
  options.pool = own.pool;
  Cholesky factor(symbolic, options);
  CholeskyStatus status;
  row.numeric = seconds(repeat, [&] { status = factor.factorize(m.valuePtr()); });
  if (!status.isOk()) std::printf("  failed at column %u\n", status.column);
  Eigen::VectorXd x;
  row.solve = seconds(repeat, [&] {
    x = b;
    factor.solve(x.data());
  });
  if (own.solution) *own.solution = x;
  row.entries = static_cast<double>(symbolic->factorEntries);
  row.flops = symbolic->flops;
  row.residual = residual(m, x, b);
  return row;
}

FactorRow runEigenLdlt(const SparseMatrix& m, const Eigen::VectorXd& b, int repeat) {
  return runSimplicial<Eigen::SimplicialLDLT<SparseMatrix>, false>(m, b, repeat);
}

FactorRow runEigenLlt(const SparseMatrix& m, const Eigen::VectorXd& b, int repeat) {
  return runSimplicial<Eigen::SimplicialLLT<SparseMatrix>, true>(m, b, repeat);
}

#ifdef ABFLAT_BENCH_CHOLMOD
FactorRow runCholmod(const SparseMatrix& matrix, const Eigen::VectorXd& rightHandSide, int repeat) {
  SparseMatrix m = matrix;
  Eigen::VectorXd b = rightHandSide;
  FactorRow row;
  cholmod_common common;
  cholmod_start(&common);
  common.nmethods = 1;
  common.method[0].ordering = CHOLMOD_METIS;
  common.supernodal = CHOLMOD_SUPERNODAL;
  cholmod_sparse a{};
  a.nrow = a.ncol = static_cast<std::size_t>(m.rows());
  a.nzmax = static_cast<std::size_t>(m.nonZeros());
  a.p = m.outerIndexPtr();
  a.i = m.innerIndexPtr();
  a.x = m.valuePtr();
  a.stype = -1;
  a.itype = CHOLMOD_INT;
  a.xtype = CHOLMOD_REAL;
  a.sorted = a.packed = 1;
  cholmod_dense rhs{};
  rhs.nrow = rhs.nzmax = rhs.d = a.nrow;
  rhs.ncol = 1;
  rhs.x = b.data();
  rhs.xtype = CHOLMOD_REAL;
  cholmod_factor* factor = nullptr;
  row.analyze = seconds(1, [&] { factor = cholmod_analyze(&a, &common); });
  row.entries = common.lnz;
  row.flops = common.fl;
  row.numeric = seconds(repeat, [&] { cholmod_factorize(&a, factor, &common); });
  Eigen::VectorXd x(m.rows());
  row.solve = seconds(repeat, [&] {
    cholmod_dense* solved = cholmod_solve(CHOLMOD_A, factor, &rhs, &common);
    std::copy_n(static_cast<double*>(solved->x), m.rows(), x.data());
    cholmod_free_dense(&solved, &common);
  });
  row.residual = residual(m, x, b);
  cholmod_free_factor(&factor, &common);
  cholmod_finish(&common);
  return row;
}
#endif

}  // namespace abflat::bench
