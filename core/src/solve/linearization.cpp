#include "solve/linearization.h"

#include <algorithm>
#include <cmath>

#include "base/constants.h"
#include "base/portable_math.h"

namespace abflat {
namespace {

/// Of w; below this the Newton model is no longer convex and the element matrix not semidefinite.
constexpr double kMinCurvature = 0.2;
/// Triangles that are one piece of work.
constexpr std::uint32_t kGrain = 2048;

std::size_t pieceCount(const AngleProblem& problem) {
  return (std::size_t{problem.triangleCount()} + kGrain - 1) / kGrain;
}
std::uint32_t beginOf(std::size_t piece) { return static_cast<std::uint32_t>(piece * kGrain); }
std::uint32_t endOf(const AngleProblem& problem, std::size_t piece) {
  return static_cast<std::uint32_t>(
      std::min<std::size_t>(problem.triangleCount(), (piece + 1) * kGrain));
}

/// Of `value(f)` over all triangles, at least 0.
template <typename Value>
double largest(const AngleProblem& problem, ThreadPool* pool, const Value& value) {
  std::vector<double> worst(pieceCount(problem), 0);
  parallelFor(pool, worst.size(), [&](std::size_t i) {
    for (std::uint32_t f = beginOf(i); f < endOf(problem, i); ++f)
      worst[i] = std::max(worst[i], value(f));
  });
  return worst.empty() ? 0 : *std::max_element(worst.begin(), worst.end());
}

/// `y`: multipliers of the triangle's rows. Returns its share of the objective.
double linearizeTriangle(const AngleProblem& problem, const std::array<double, 6>& y,
                         const std::vector<double>& x, std::uint32_t f, Curvature mode,
                         const Barrier* barrier, Linearization& out) {
  Element& e = out.elements[f];
  double objective = 0;
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
    out.logSine[c] = portable::log(sine);
    e.cot[k] = cosine / sine;
    e.triangleResidual += x[c];
    objective += w * distance * distance;
  }
  e.determinant =
      e.hessian[0] * e.hessian[1] + e.hessian[1] * e.hessian[2] + e.hessian[2] * e.hessian[0];
  return objective;
}

void addResiduals(const AngleProblem& problem, const ConstraintRows& rows,
                  const std::vector<double>& x, Linearization& out) {
  out.residual.assign(rows.count(), 0);
  for (std::uint32_t v = 0; v < problem.vertexCount(); ++v)
    out.residual[rows.ofVertex[v]] = -problem.angleSum[v];
  for (std::uint32_t f = 0; f < problem.triangleCount(); ++f) {
    const double* logSine = &out.logSine[3 * static_cast<std::size_t>(f)];
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t v = problem.vertexOfCorner[3 * f + k];
      out.residual[rows.ofVertex[v]] += x[3 * f + k];
      if (!problem.isBoundary[v])
        out.residual[rows.ofVertex[v] + 1] += logSine[(k + 1) % 3] - logSine[(k + 2) % 3];
    }
  }
}

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
               Linearization& out, Curvature mode, const Barrier* barrier, ThreadPool* pool) {
  out.elements.resize(problem.triangleCount());
  out.logSine.resize(x.size());
  const std::size_t pieces = pieceCount(problem);
  std::vector<double> objective(pieces, 0);
  parallelFor(pool, pieces, [&](std::size_t i) {
    for (std::uint32_t f = beginOf(i); f < endOf(problem, i); ++f)
      objective[i] += linearizeTriangle(problem, gatherRows(problem, rows, rowMultipliers, f), x, f,
                                        mode, barrier, out);
  });
  out.objective = 0;
  for (const double part : objective) out.objective += part;
  out.edgeResidual.assign(problem.edgeCorners.size(), -problem.edgeLimit);
  for (std::size_t i = 0; i < problem.edgeCorners.size(); ++i)
    for (const std::uint32_t c : problem.edgeCorners[i]) out.edgeResidual[i] += x[c];
  addResiduals(problem, rows, x, out);
}

double constraintResidual(const AngleProblem& problem, const ConstraintRows& rows,
                          const Linearization& lin, ThreadPool* pool) {
  double worst = largest(
      problem, pool, [&](std::uint32_t f) { return std::abs(lin.elements[f].triangleResidual); });
  for (std::uint32_t v = 0; v < problem.vertexCount(); ++v) {
    const std::uint32_t r = rows.ofVertex[v];
    if (problem.isStraight[v])
      worst = std::max(worst, std::abs(lin.residual[r]));
    else if (problem.isBoundary[v])
      worst = std::max(worst, lin.residual[r]);
    else
      worst = std::max({worst, std::abs(lin.residual[r]), std::abs(lin.residual[r + 1])});
  }
  for (const double g : lin.edgeResidual) worst = std::max(worst, g);
  return worst;
}

double gradientResidual(const AngleProblem& problem, const ConstraintRows& rows,
                        const Linearization& lin, const Multipliers& multipliers,
                        ThreadPool* pool) {
  return largest(problem, pool, [&](std::uint32_t f) {
    const Element& e = lin.elements[f];
    const std::array<double, 3> z =
        applyTransposedJacobian(e, gatherRows(problem, rows, multipliers.row, f));
    double worst = 0;
    for (std::uint32_t k = 0; k < 3; ++k) {
      double g = e.gradient[k] + z[k] + multipliers.triangle[f];
      if (!problem.edgeOfCorner.empty() && problem.edgeOfCorner[3 * f + k] != kNone)
        g += multipliers.edge[problem.edgeOfCorner[3 * f + k]];
      worst = std::max(worst, std::abs(g) * problem.target[3 * f + k] / 2);
    }
    return worst;
  });
}

}  // namespace abflat
