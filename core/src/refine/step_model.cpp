#include "refine/step_model.h"

#include <algorithm>
#include <utility>

#include "base/point2.h"
#include "mesh/triangle_geometry.h"

namespace abflat {
namespace {

std::vector<std::uint32_t> rankOfRows(const IdVector<ChartVertex, std::uint32_t>& ofVertices) {
  std::vector<std::uint32_t> out;
  for (const std::uint32_t rank : ofVertices) out.insert(out.end(), 2, rank);
  return out;
}

/// Per row: 0 for u, 1 for v.
std::vector<std::uint8_t> kindsOfRows(std::size_t count) {
  std::vector<std::uint8_t> out(count);
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = i % 2;
  return out;
}

}  // namespace

StepModel::StepModel(const Objective& objective, Anchors anchors, const RefineOptions& options)
    : anchors_(std::move(anchors)),
      options_(options),
      eliminationRank_(rankOfRows(options.eliminationRank.empty() ? objective.chart.eliminationRank
                                                                  : options.eliminationRank)),
      rows_(layoutRows(objective.chart, options.pool)),
      matrix_(rows_.matrix(), freeOf(objective.shape.entries())),
      memory_{options.allowedBytes} {
  makeSolver();
  if (solver_->eliminationRank()) rows_.divide(*solver_->eliminationRank());
}

void StepModel::makeSolver() {
  const auto rows = static_cast<std::size_t>(matrix_.sum().rows());
  solver_ = makeRowSolverWithin(matrix_.sum(), kindsOfRows(rows), memory_, options_.pool,
                                eliminationRank_);
}

/// The entries without those in fixed rows or columns.
SparseEntries StepModel::freeOf(SparseEntries entries) const {
  const auto isFixed = [&](const auto& e) { return isFixedRow(e.row()) || isFixedRow(e.col()); };
  entries.erase(std::remove_if(entries.begin(), entries.end(), isFixed), entries.end());
  return entries;
}

void StepModel::holdArm(const std::vector<double>& uv) {
  if (!anchors_.arm.exists()) return;
  const Point2 arm = pointAt(uv, anchors_.arm), centre = pointAt(uv, anchors_.centre);
  const double x = arm[0] - centre[0], y = arm[1] - centre[1], length = norm(x, y);
  const double acrossX = -y / length, acrossY = x / length;
  double *ofU = rows_.diagonal(2 * anchors_.arm), *ofV = rows_.diagonal(2 * anchors_.arm + 1);
  ofU[0] += acrossX * acrossX;
  ofU[1] += acrossX * acrossY;
  ofV[0] += acrossY * acrossY;
}

Expansion StepModel::expand(const Objective& objective, const std::vector<double>& uv,
                            ElementCurvature curvature) {
  assembleDerivatives(objective.chart, objective.rest, {uv, objective.energy, curvature},
                      anchors_.isFixed, rows_);
  holdArm(uv);
  Expansion out{rows_.rightHandSide, {}};
  objective.addOutlineDerivatives(uv, out.gradient, out.outline);
  for (int row = 0; row < out.gradient.size(); ++row)
    if (isFixedRow(row)) out.gradient[row] = 0;
  return out;
}

bool StepModel::minimize(const Expansion& at, const ForeseenContacts* foreseen, double tolerance,
                         std::vector<double>& step) {
  ++solves_;
  Eigen::VectorXd b = at.gradient;
  SparseEntries outline = at.outline;
  if (foreseen) foreseen->addDerivatives(b, outline);
  for (int row = 0; row < b.size(); ++row) b[row] = isFixedRow(row) ? 0 : -b[row];
  if (matrix_.add(freeOf(std::move(outline)))) makeSolver();
  solver_->forget();  // iterating with an old factor would cost more than a new one
  Eigen::VectorXd x = Eigen::VectorXd::Zero(b.size());
  const double most = tolerance * b.lpNorm<Eigen::Infinity>();
  if (!solver_->solve(matrix_.sum(), b, most, x) || !x.allFinite()) return false;
  step.assign(x.data(), x.data() + x.size());
  return true;
}

}  // namespace abflat
