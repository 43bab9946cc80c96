#include "pin/relax_conformally.h"

#include "pin/conformal_energy.h"
#include "solve/row_solver.h"
#include "solve/sparse_assembly.h"

namespace abflat {
namespace {

using Matrix = Eigen::SparseMatrix<double>;

/// Relative to the largest entry of the right-hand side, if iterations replace a factor.
constexpr double kTolerance = 1e-13;

/// The rows of the unknowns that are not pinned; contributions of the pins move to the right-hand
/// side.
struct Reduced {
  Matrix lower;  ///< triangle
  Eigen::VectorXd rhs;
};

/// `unknown`: row of each entry of x; -1 for pinned entries, whose values are in `x`.
Reduced withoutPins(const Matrix& energy, const std::vector<int>& unknown, int count,
                    const Eigen::VectorXd& x) {
  Reduced out{{}, Eigen::VectorXd::Zero(count)};
  SparseEntries entries;
  entries.reserve(static_cast<std::size_t>(energy.nonZeros() / 2 + count));
  for (Eigen::Index c = 0; c < energy.outerSize(); ++c)
    for (Matrix::InnerIterator e(energy, c); e; ++e) {
      const int row = unknown[static_cast<std::size_t>(e.row())];
      const int column = unknown[static_cast<std::size_t>(c)];
      if (row < 0) continue;
      if (column > row) continue;
      if (column >= 0)
        entries.emplace_back(row, column, e.value());
      else
        out.rhs[row] -= e.value() * x[c];
    }
  out.lower = assembled(count, entries);
  return out;
}

}  // namespace

bool relaxConformally(const FlatRegion& region, const std::vector<double>& angles,
                      const std::vector<ChartVertex>& pinned, std::vector<double>& uv,
                      FactorMemory& memory, ThreadPool* pool) {
  const std::size_t n = uv.size() / 2;
  std::vector<int> unknown(2 * n, 0);
  for (const ChartVertex pin : pinned) unknown[pin] = unknown[n + pin] = -1;
  int count = 0;
  std::vector<std::uint8_t> kind;
  for (std::size_t i = 0; i < 2 * n; ++i)
    if (unknown[i] == 0) {
      unknown[i] = count++;
      kind.push_back(i < n ? 0 : 1);
    }
  if (count == 0) return true;
  Eigen::VectorXd x(static_cast<Eigen::Index>(2 * n));
  for (std::size_t i = 0; i < 2 * n; ++i)
    x[static_cast<Eigen::Index>(i)] = uv[i < n ? 2 * i : 2 * (i - n) + 1];
  const Reduced system = withoutPins(conformalEnergy(region, n, angles), unknown, count, x);
  const std::unique_ptr<RowSolver> solver = makeRowSolverWithin(system.lower, kind, memory, pool);
  const double tolerance = memory.fits() ? 0 : kTolerance * system.rhs.lpNorm<Eigen::Infinity>();
  Eigen::VectorXd solved = Eigen::VectorXd::Zero(count);
  if (!solver->solve(system.lower, system.rhs, tolerance, solved) || !solved.allFinite())
    return false;
  for (std::size_t i = 0; i < 2 * n; ++i)
    if (unknown[i] >= 0) uv[i < n ? 2 * i : 2 * (i - n) + 1] = solved(unknown[i]);
  return true;
}

}  // namespace abflat
