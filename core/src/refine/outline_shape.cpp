#include "refine/outline_shape.h"

#include <array>
#include <cmath>
#include <limits>

#include "base/constants.h"
#include "base/portable_math.h"
#include "mesh/triangle_geometry.h"

namespace abflat {
namespace {

/// Stiffness of straight parts in the perpendicular direction; that of a vertex of the surface is
/// about 10.
constexpr double kStraightStiffness = 1e4;
/// Strength of all bounds together.
constexpr double kBoundStrength = 3e-3;

}  // namespace

OutlineShape::OutlineShape(const DiskChart& chart, const OutlineRules& rules)
    : chart_(chart), straight_(chart, rules.straight), margin_(rules.margin) {
  if (!rules.bounds.empty()) findBounds(rules);
}

void OutlineShape::findBounds(const OutlineRules& rules) {
  IdVector<BoundaryIndex, double> length;
  double sum = 0;
  for (const BoundaryIndex i : rules.bounds.ids()) {
    length.push_back(norm(edgeVector(chart_.positions, chart_.boundaryVertex(i),
                                     chart_.boundaryVertex(chart_.after(i)))));
    sum += length.back();
  }
  for (const BoundaryIndex i : rules.bounds.ids()) {
    const bool isStraight = !rules.straight.empty() && rules.straight[i];
    if (rules.bounds[i] >= 2 || isStraight) continue;
    const double share = (length[i] + length[chart_.before(i)]) / (2 * sum);
    bounds_.push_back({i, rules.bounds[i] * kPi, kBoundStrength * share});
  }
}

OutlineShape::Slack OutlineShape::slackOf(const Bound& bound, const std::vector<double>& uv) const {
  const std::array<ChartVertex, 3> v = cornerAt(bound.place);
  const auto [x, p, q] = pointsOf(uv, {v[0], v[1], v[2]});
  const double px = p[0] - x[0], py = p[1] - x[1], qx = q[0] - x[0], qy = q[1] - x[1];
  // From the outgoing edge to the incoming one: the surface is on the left.
  double angle = portable::atan2(qx * py - qy * px, qx * px + qy * py);
  if (angle < 0) angle += 2 * kPi;
  Slack out{bound.most - angle, {v, {}}};
  const double p2 = px * px + py * py, q2 = qx * qx + qy * qy;
  double* change = out.contact.change;
  change[2] = py / p2;
  change[3] = -px / p2;
  change[4] = -qy / q2;
  change[5] = qx / q2;
  for (std::size_t d = 0; d < 2; ++d) change[d] = -change[2 + d] - change[4 + d];
  return out;
}

double OutlineShape::energy(const std::vector<double>& uv) const {
  double sum = 0;
  for (const Bound& b : bounds_) {
    const double slack = slackOf(b, uv).value;
    if (!(slack > 0)) return std::numeric_limits<double>::infinity();
    sum += b.weight * barrierAt(slack / margin_).value;
  }
  return sum;
}

SparseEntries OutlineShape::entries() const {
  SparseEntries out;
  const auto add = [&](const std::array<ChartVertex, 3>& vertices) {
    for (const ChartVertex a : vertices)
      for (const ChartVertex b : vertices)
        for (const std::uint32_t i : {2 * a, 2 * a + 1})
          for (const std::uint32_t j : {2 * b, 2 * b + 1})
            if (i >= j) out.emplace_back(static_cast<int>(i), static_cast<int>(j), 0);
  };
  for (const Bound& b : bounds_) add(cornerAt(b.place));
  for (const StraightParts::Run& run : straight_)
    straight_.within(run, [&](ChartVertex v) {
      add({v, chart_.boundaryVertex(run.from), chart_.boundaryVertex(run.to)});
    });
  return out;
}

void OutlineShape::addDerivatives(const std::vector<double>& uv, Eigen::VectorXd& gradient,
                                  SparseEntries& hessian) const {
  for (const Bound& b : bounds_) {
    const Slack s = slackOf(b, uv);
    if (s.value < margin_)
      s.contact.addBarrier(barrierAt(s.value / margin_), margin_, b.weight, gradient, hessian);
  }
  const double stiffness = kStraightStiffness / surfaceArea(chart_);
  for (const StraightParts::Run& run : straight_) {
    const ChartVertex a = chart_.boundaryVertex(run.from), b = chart_.boundaryVertex(run.to);
    const double ux = uv[2 * b] - uv[2 * a], uy = uv[2 * b + 1] - uv[2 * a + 1];
    const double length = norm(ux, uy);
    straight_.within(run, [&](ChartVertex v) {
      distanceContact({v, a, b}, straight_.shareOf(run, v, uv), {-uy / length, ux / length})
          .addDerivatives(0, stiffness, gradient, hessian);
    });
  }
}

}  // namespace abflat
