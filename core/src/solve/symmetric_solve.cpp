#include "solve/symmetric_solve.h"

#include "solve/cholesky/cholesky.h"
#include "solve/sparse_assembly.h"

namespace abflat {

std::vector<double> solveSymmetric(const SparseSystem& system) {
  const Eigen::SparseMatrix<double> m = assembled(system.size, system.entries);
  Cholesky factor(std::make_shared<const CholeskySymbolic>(analyzePattern(
      {static_cast<std::uint32_t>(m.rows()), m.outerIndexPtr(), m.innerIndexPtr()})));
  if (!factor.factorize(m.valuePtr()).isOk()) return {};
  std::vector<double> x = system.b;
  factor.solve(x.data(), x.size() / static_cast<std::size_t>(system.size));
  return x;
}

}  // namespace abflat
