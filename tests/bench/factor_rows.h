#pragma once

#include <Eigen/SparseCore>

#include "base/parallel.h"
#include "solve/cholesky/front_kernel.h"

namespace abflat::bench {

/// One solver on one matrix.
struct FactorRow {
  double analyze = 0, numeric = 0, solve = 0;  ///< seconds, medians
  double entries = 0, flops = 0, residual = 0;

  double all() const { return analyze + numeric + solve; }
};

/// Lower triangle of a symmetric matrix, by columns.
using SparseMatrix = Eigen::SparseMatrix<double>;

/// What it computed, where it is compared to the last bit.
struct OwnOptions {
  SimdWidth width = widestSimd();
  ThreadPool* pool = nullptr;
  Eigen::VectorXd* solution = nullptr;
};
FactorRow runOwn(const SparseMatrix& m, const Eigen::VectorXd& b, int repeat,
                 const OwnOptions& options = {});
FactorRow runEigenLdlt(const SparseMatrix& m, const Eigen::VectorXd& b, int repeat);
FactorRow runEigenLlt(const SparseMatrix& m, const Eigen::VectorXd& b, int repeat);

#ifdef ABFLAT_BENCH_CHOLMOD
/// Supernodal, ordered by METIS.
FactorRow runCholmod(const SparseMatrix& matrix, const Eigen::VectorXd& rightHandSide, int repeat);
#endif

}  // namespace abflat::bench
