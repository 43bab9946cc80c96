#include "solve/linearization.h"

#include <algorithm>
#include <cmath>

#include "angle/constants.h"
#include "portable_math.h"

namespace abflat {
namespace {

/// Of w; below this the Newton model is no longer convex and the element matrix not semidefinite.
constexpr double kMinCurvature = 0.2;

}  // namespace

ConstraintRows numberRows(const AngleProblem& problem) {
  ConstraintRows rows;
  rows.ofVertex.resize(problem.vertexCount() + 1);
  std::uint32_t n = 0;
  for (std::uint32_t v = 0; v < problem.vertexCount(); ++v) {
    rows.ofVertex[v] = n;
    n += problem.isBoundary[v] ? 1 : 2;
  }
  rows.ofVertex.back() = n;
  return rows;
}

std::vector<std::uint8_t> rowKinds(const ConstraintRows& rows) {
  std::vector<std::uint8_t> kind(rows.count(), 0);
  for (std::size_t v = 0; v + 1 < rows.ofVertex.size(); ++v)
    if (rows.ofVertex[v + 1] - rows.ofVertex[v] == 2) kind[rows.ofVertex[v] + 1] = 1;
  return kind;
}

void linearize(const AngleProblem& problem, const ConstraintRows& rows,
               const std::vector<double>& x, const std::vector<double>& rowMultipliers,
               Linearization& out, Curvature mode, const Barrier* barrier) {
  out.elements.resize(problem.triangleCount());
  out.residual.assign(rows.count(), 0);
  out.objective = 0;
  for (std::uint32_t v = 0; v < problem.vertexCount(); ++v)
    out.residual[rows.ofVertex[v]] = -problem.angleSum[v];
  out.edgeResidual.assign(problem.edgeCorners.size(), -problem.edgeLimit);
  for (std::size_t i = 0; i < problem.edgeCorners.size(); ++i)
    for (const std::uint32_t c : problem.edgeCorners[i]) out.edgeResidual[i] += x[c];
  for (std::uint32_t f = 0; f < problem.triangleCount(); ++f) {
    Element& e = out.elements[f];
    const std::array<double, 6> y = gatherRows(problem, rows, rowMultipliers, f);
    std::array<double, 3> logSin;
    e.triangleResidual = -kPi;
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t c = 3 * f + k;
      const double w = problem.weight[c], distance = x[c] - problem.target[c];
      const auto [sine, cosine] = portable::sinCos(x[c]);
      const double m = y[2 * ((k + 2) % 3) + 1] - y[2 * ((k + 1) % 3) + 1];
      e.hessian[k] = 2 * w - m / (sine * sine);
      if (mode == Curvature::Clamped) e.hessian[k] = std::max(e.hessian[k], kMinCurvature * w);
      e.gradient[k] = 2 * w * distance;
      if (barrier) {
        e.hessian[k] += barrier->dual[c] / x[c];
        e.gradient[k] -= barrier->tau / x[c];
      }
      logSin[k] = portable::log(sine);
      e.cot[k] = cosine / sine;
      e.triangleResidual += x[c];
      out.objective += w * distance * distance;
    }
    e.determinant =
        e.hessian[0] * e.hessian[1] + e.hessian[1] * e.hessian[2] + e.hessian[2] * e.hessian[0];
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t v = problem.vertexOfCorner[3 * f + k];
      out.residual[rows.ofVertex[v]] += x[3 * f + k];
      if (!problem.isBoundary[v])
        out.residual[rows.ofVertex[v] + 1] += logSin[(k + 1) % 3] - logSin[(k + 2) % 3];
    }
  }
}

double constraintResidual(const AngleProblem& problem, const ConstraintRows& rows,
                          const Linearization& lin) {
  double worst = 0;
  for (const Element& e : lin.elements) worst = std::max(worst, std::abs(e.triangleResidual));
  for (std::uint32_t v = 0; v < problem.vertexCount(); ++v) {
    const std::uint32_t r = rows.ofVertex[v];
    if (problem.isBoundary[v])
      worst = std::max(worst, lin.residual[r]);
    else
      worst = std::max({worst, std::abs(lin.residual[r]), std::abs(lin.residual[r + 1])});
  }
  for (const double g : lin.edgeResidual) worst = std::max(worst, g);
  return worst;
}

double gradientResidual(const AngleProblem& problem, const ConstraintRows& rows,
                        const Linearization& lin, const Multipliers& multipliers) {
  double worst = 0;
  for (std::uint32_t f = 0; f < problem.triangleCount(); ++f) {
    const Element& e = lin.elements[f];
    const std::array<double, 3> z =
        applyTransposedJacobian(e, gatherRows(problem, rows, multipliers.row, f));
    for (std::uint32_t k = 0; k < 3; ++k) {
      double g = e.gradient[k] + z[k] + multipliers.triangle[f];
      if (!problem.edgeOfCorner.empty() && problem.edgeOfCorner[3 * f + k] != kNone)
        g += multipliers.edge[problem.edgeOfCorner[3 * f + k]];
      worst = std::max(worst, std::abs(g) * problem.target[3 * f + k] / 2);
    }
  }
  return worst;
}

}  // namespace abflat
