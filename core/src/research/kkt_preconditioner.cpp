#include "research/kkt_preconditioner.h"

#include <algorithm>
#include <cmath>

namespace abflat {
namespace {

/// As a share of w: smaller entries of |H| are raised to this.
constexpr double kLeastCurvature = 0.05;

double inverseSum(const Element& e) {
  return e.determinant / (e.hessian[0] * e.hessian[1] * e.hessian[2]);
}

}  // namespace

KktPreconditioner::KktPreconditioner(const AngleProblem& problem, const ConstraintRows& rows)
    : problem_(problem), rows_(rows), schur_(problem, rows) {
  placeInBlock_.resize(rows.count());
  isWheel_.assign(rows.count(), 0);
  for (const ChartVertex v : problem.vertices())
    for (std::uint32_t r = rows.ofVertex[v]; r < rows.ofVertex[v + 1]; ++r) {
      isWheel_[r] = r > rows.ofVertex[v];
      std::vector<std::uint32_t>& list = blocks_[isWheel_[r]].rows;
      placeInBlock_[r] = static_cast<std::uint32_t>(list.size());
      list.push_back(r);
    }
}

bool KktPreconditioner::factor(const Linearization& lin, const std::vector<std::uint8_t>& active,
                               const std::vector<double>& rowScale) {
  Linearization positive = lin;
  for (const ChartTriangle f : problem_.triangles()) {
    Element& e = positive.elements[f];
    std::array<double, 3>& h = e.hessian;
    for (std::size_t k = 0; k < 3; ++k)
      h[k] = std::max(std::abs(h[k]), kLeastCurvature * problem_.weight[cornerOf(f, k)]);
    e.determinant = h[0] * h[1] + h[1] * h[2] + h[2] * h[0];
  }
  schur_.assemble(positive, active);
  const Eigen::SparseMatrix<double>& s = schur_.matrix();
  std::array<bool, 2> isNew{};
  for (std::size_t i = 0; i < 2; ++i) {
    isNew[i] = blocks_[i].matrix.rows() == 0;
    const auto n = static_cast<Eigen::Index>(blocks_[i].rows.size());
    blocks_[i].matrix.resize(n, n);
  }
  // Within a block, rows keep their order.
  for (int c = 0; c < s.outerSize(); ++c) {
    const auto column = static_cast<std::size_t>(c);
    const std::uint8_t i = isWheel_[column];
    const auto place = static_cast<Eigen::Index>(placeInBlock_[column]);
    blocks_[i].matrix.startVec(place);
    for (Eigen::SparseMatrix<double>::InnerIterator it(s, c); it; ++it) {
      const auto row = static_cast<std::size_t>(it.row());
      if (isWheel_[row] != i) continue;
      blocks_[i].matrix.insertBackByOuterInner(
          place, static_cast<Eigen::Index>(placeInBlock_[row])) = it.value();
    }
  }
  for (std::size_t i = 0; i < 2; ++i) {
    Block& b = blocks_[i];
    if (b.rows.empty()) continue;
    b.matrix.finalize();
    if (isNew[i]) b.factor.analyzePattern(b.matrix);
    b.factor.factorize(b.matrix);
    if (b.factor.info() != Eigen::Success || b.factor.vectorD().minCoeff() <= 0) return false;
  }
  elements_ = std::move(positive.elements);
  active_ = active;
  rowScale_ = rowScale;
  return true;
}

void KktPreconditioner::apply(const Eigen::VectorXd& in, Eigen::VectorXd& out) const {
  const auto corners = static_cast<Eigen::Index>(problem_.vertexOfCorner.size());
  const auto firstRow = corners + static_cast<Eigen::Index>(problem_.triangleCount());
  out.resize(in.size());
  // Rows of inactive bounds are identity rows and take no part in the elimination.
  std::vector<double> value(rows_.count());
  for (std::uint32_t r = 0; r < rows_.count(); ++r) value[r] = in[firstRow + r] / rowScale_[r];
  const auto isOff = [&](ChartVertex v) { return problem_.isBoundary[v] && !active_[v]; };
  for (const ChartTriangle f : problem_.triangles()) {
    const Element& e = elements_[f];
    std::array<double, 3> z = unitStep(e);
    for (unsigned k = 0; k < 3; ++k) z[k] *= in[corners + f];
    const std::array<double, 6> y = applyJacobian(e, z);
    for (std::size_t k = 0; k < 3; ++k) {
      const ChartVertex v = problem_.vertexOfCorner[cornerOf(f, k)];
      if (!isOff(v)) value[rows_.ofVertex[v]] -= y[2 * k];
      if (!problem_.isBoundary[v]) value[rows_.ofVertex[v] + 1] -= y[2 * k + 1];
    }
  }
  for (const Block& b : blocks_) {
    if (b.rows.empty()) continue;
    Eigen::VectorXd part(static_cast<Eigen::Index>(b.rows.size()));
    for (std::size_t i = 0; i < b.rows.size(); ++i)
      part[static_cast<Eigen::Index>(i)] = value[b.rows[i]];
    const Eigen::VectorXd solved = b.factor.solve(part);
    for (std::size_t i = 0; i < b.rows.size(); ++i)
      value[b.rows[i]] = solved[static_cast<Eigen::Index>(i)];
  }
  for (std::uint32_t r = 0; r < rows_.count(); ++r) out[firstRow + r] = value[r] / rowScale_[r];
  for (const ChartVertex v : problem_.vertices())
    if (isOff(v)) value[rows_.ofVertex[v]] = 0;
  for (const ChartTriangle f : problem_.triangles()) {
    const Element& e = elements_[f];
    const std::array<double, 3> z =
        applyTransposedJacobian(e, gatherRows(problem_, rows_, value, f));
    const std::array<double, 3> unit = unitStep(e);
    out[corners + f] = in[corners + f] / inverseSum(e);
    for (unsigned k = 0; k < 3; ++k) {
      out[corners + f] -= unit[k] * z[k];
      out[cornerOf(f, k)] = in[cornerOf(f, k)] / e.hessian[k];
    }
  }
}

}  // namespace abflat
