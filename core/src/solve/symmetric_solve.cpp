#include "solve/symmetric_solve.h"

#include "solve/cholesky/cholesky.h"

namespace abflat {

Eigen::MatrixXd solveSymmetric(const Eigen::SparseMatrix<double>& m, const Eigen::MatrixXd& b) {
  Cholesky factor(std::make_shared<const CholeskySymbolic>(analyzePattern(
      {static_cast<std::uint32_t>(m.rows()), m.outerIndexPtr(), m.innerIndexPtr()})));
  if (!factor.factorize(m.valuePtr()).isOk()) return {};
  Eigen::MatrixXd x = b;
  factor.solve(x.data(), static_cast<std::size_t>(x.cols()));
  return x;
}

}  // namespace abflat
