#include "solve/general_solve.h"

#include "solve/cholesky/cholesky.h"
#include "solve/sparse_assembly.h"

namespace abflat {
namespace {

using Matrix = Eigen::SparseMatrix<double>;

/// The matrix's transpose times itself, lower triangle.
Matrix squared(const Matrix& rows) {
  SparseEntries entries;
  for (Eigen::Index r = 0; r < rows.cols(); ++r)
    for (Matrix::InnerIterator i(rows, r); i; ++i)
      for (Matrix::InnerIterator j(rows, r); j && j.row() <= i.row(); ++j)
        entries.emplace_back(static_cast<int>(i.row()), static_cast<int>(j.row()),
                             i.value() * j.value());
  return assembled(rows.cols(), entries);
}

}  // namespace

std::vector<double> solveGeneral(const SparseSystem& system) {
  const Matrix m = assembled(system.size, system.entries);
  const Eigen::Map<const Eigen::MatrixXd> b(system.b.data(), m.rows(),
                                            static_cast<Eigen::Index>(system.b.size()) / m.rows());
  const Eigen::VectorXd diagonal = m.diagonal();
  if (!(diagonal.array() > 0).all()) return {};
  Matrix rows = m.transpose();  // one column per row of m
  for (Eigen::Index r = 0; r < rows.cols(); ++r)
    for (Matrix::InnerIterator i(rows, r); i; ++i) i.valueRef() /= diagonal[r];
  const Matrix square = squared(rows);
  Cholesky factor(std::make_shared<const CholeskySymbolic>(
      analyzePattern({static_cast<std::uint32_t>(square.rows()), square.outerIndexPtr(),
                      square.innerIndexPtr()})));
  if (!factor.factorize(square.valuePtr()).isOk()) return {};
  constexpr int kMostRefinements = 20;
  constexpr double kFallsNoMore = 0.5, kSolved = 1e-6;
  Eigen::MatrixXd x = Eigen::MatrixXd::Zero(b.rows(), b.cols());
  Eigen::MatrixXd residual = diagonal.cwiseInverse().asDiagonal() * b;
  const double first = residual.norm();
  double size = first;
  for (int i = 0; i < kMostRefinements && size > 0; ++i) {
    Eigen::MatrixXd step = rows * residual;
    factor.solve(step.data(), static_cast<std::size_t>(step.cols()));
    residual -= rows.transpose() * step;
    const double left = residual.norm();
    if (!(left < size)) break;
    x += step;
    const bool falls = left < kFallsNoMore * size;
    size = left;
    if (!falls) break;
  }
  if (!(size <= kSolved * first)) return {};
  return {x.data(), x.data() + x.size()};
}

}  // namespace abflat
