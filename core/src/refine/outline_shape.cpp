#include "refine/outline_shape.h"

#include <array>
#include <cmath>
#include <limits>

#include "base/constants.h"
#include "base/portable_math.h"
#include "mesh/triangle_geometry.h"

namespace abflat {
namespace {

/// Of straight parts across, beside about 10 for a vertex of the surface.
constexpr double kStiffness = 1e4;
/// Of all bounds together.
constexpr double kStrength = 3e-3;

}  // namespace

OutlineShape::OutlineShape(const DiskChart& chart, const OutlineRules& rules)
    : chart_(chart), margin_(rules.margin) {
  if (!rules.straight.empty()) findRuns(rules.straight);
  if (!rules.bounds.empty()) findBounds(rules);
}

void OutlineShape::findRuns(const std::vector<std::uint8_t>& straight) {
  const auto n = static_cast<std::uint32_t>(straight.size());
  for (std::uint32_t i = 0; i < n; ++i) {
    if (straight[i] || !straight[(i + 1) % n]) continue;
    Run run{i, i + 2};
    while (straight[run.to % n]) ++run.to;
    runs_.push_back(run);
  }
}

void OutlineShape::findBounds(const OutlineRules& rules) {
  const auto n = static_cast<std::uint32_t>(rules.bounds.size());
  std::vector<double> length;
  double sum = 0;
  for (std::uint32_t i = 0; i < n; ++i) {
    length.push_back(norm(edgeVector(chart_.positions, vertexAt(i), vertexAt(i + 1))));
    sum += length.back();
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    const bool isStraight = !rules.straight.empty() && rules.straight[i];
    if (rules.bounds[i] >= 2 || isStraight) continue;
    const double share = (length[i] + length[(i + n - 1) % n]) / (2 * sum);
    bounds_.push_back({i, rules.bounds[i] * kPi, kStrength * share});
  }
}

template <class Use>
void OutlineShape::within(const Run& run, const std::vector<double>& uv, const Use& use) const {
  const double *a = &uv[2 * vertexAt(run.from)], *b = &uv[2 * vertexAt(run.to)];
  const double ux = b[0] - a[0], uy = b[1] - a[1], square = ux * ux + uy * uy;
  for (std::uint32_t i = run.from + 1; i < run.to; ++i) {
    const double* x = &uv[2 * vertexAt(i)];
    use(i, ((x[0] - a[0]) * ux + (x[1] - a[1]) * uy) / square);
  }
}

void OutlineShape::straighten(std::vector<double>& uv) const {
  for (const Run& run : runs_)
    within(run, uv, [&](std::uint32_t i, double share) {
      const double *a = &uv[2 * vertexAt(run.from)], *b = &uv[2 * vertexAt(run.to)];
      for (std::size_t d = 0; d < 2; ++d) uv[2 * vertexAt(i) + d] = a[d] + share * (b[d] - a[d]);
    });
}

OutlineShape::Slack OutlineShape::slackOf(const Bound& bound, const std::vector<double>& uv) const {
  const std::size_t n = chart_.boundary.size();
  const std::uint32_t v[3] = {vertexAt(bound.place), vertexAt(bound.place + n - 1),
                              vertexAt(bound.place + 1)};
  const double *x = &uv[2 * v[0]], *p = &uv[2 * v[1]], *q = &uv[2 * v[2]];
  const double px = p[0] - x[0], py = p[1] - x[1], qx = q[0] - x[0], qy = q[1] - x[1];
  // From the edge that goes on to the one that came: the surface is on the left.
  double angle = portable::atan2(qx * py - qy * px, qx * px + qy * py);
  if (angle < 0) angle += 2 * kPi;
  Slack out{bound.most - angle, {{v[0], v[1], v[2]}, {}}};
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
  const auto add = [&](const std::array<std::uint32_t, 3>& vertices) {
    for (const std::uint32_t a : vertices)
      for (const std::uint32_t b : vertices)
        for (const std::uint32_t i : {2 * a, 2 * a + 1})
          for (const std::uint32_t j : {2 * b, 2 * b + 1})
            if (i >= j) out.emplace_back(static_cast<int>(i), static_cast<int>(j), 0);
  };
  for (const Bound& b : bounds_)
    add({vertexAt(b.place), vertexAt(b.place + chart_.boundary.size() - 1), vertexAt(b.place + 1)});
  for (const Run& run : runs_)
    for (std::uint32_t i = run.from + 1; i < run.to; ++i)
      add({vertexAt(i), vertexAt(run.from), vertexAt(run.to)});
  return out;
}

void OutlineShape::addDerivatives(const std::vector<double>& uv, Eigen::VectorXd& gradient,
                                  SparseEntries& hessian) const {
  for (const Bound& b : bounds_) {
    const Slack s = slackOf(b, uv);
    if (s.value < margin_)
      s.contact.addBarrier(barrierAt(s.value / margin_), margin_, b.weight, gradient, hessian);
  }
  const double stiffness = kStiffness / surfaceArea(chart_);
  for (const Run& run : runs_) {
    const std::uint32_t a = vertexAt(run.from), b = vertexAt(run.to);
    const double ux = uv[2 * b] - uv[2 * a], uy = uv[2 * b + 1] - uv[2 * a + 1];
    const double length = norm(ux, uy);
    within(run, uv, [&](std::uint32_t i, double share) {
      distanceContact({vertexAt(i), a, b}, share, -uy / length, ux / length)
          .addDerivatives(0, stiffness, gradient, hessian);
    });
  }
}

}  // namespace abflat
