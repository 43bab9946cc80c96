#include "solve/linearization.h"

#include <algorithm>
#include <cmath>

#include "base/constants.h"
#include "base/portable_math.h"

namespace abflat {
namespace {

/// As a share of w: below this the Newton model is no longer convex and the element matrix not
/// semidefinite.
constexpr double kMinCurvature = 0.2;
/// Triangles per piece of work.
constexpr std::size_t kTrianglesPerPiece = 2048;

std::size_t pieceCount(const AngleProblem& problem) {
  return (problem.triangles().size() + kTrianglesPerPiece - 1) / kTrianglesPerPiece;
}
IdRange<ChartTriangle> pieceOf(const AngleProblem& problem, std::size_t i) {
  return {ChartTriangle(i * kTrianglesPerPiece),
          ChartTriangle(std::min(problem.triangles().size(), (i + 1) * kTrianglesPerPiece))};
}

/// The largest `value(f)` over all triangles, but at least 0.
template <typename Value>
double largest(const AngleProblem& problem, ThreadPool* pool, const Value& value) {
  std::vector<double> worst(pieceCount(problem), 0);
  parallelFor(pool, worst.size(), [&](std::size_t i) {
    for (const ChartTriangle f : pieceOf(problem, i)) worst[i] = std::max(worst[i], value(f));
  });
  return worst.empty() ? 0 : *std::max_element(worst.begin(), worst.end());
}

/// `y`: multipliers of the triangle's rows. Returns the triangle's share of the objective.
double linearizeTriangle(const AngleProblem& problem, const std::array<double, 6>& y,
                         ChartTriangle f, const LinearizationPoint& at, Linearization& out) {
  const std::vector<double>& x = at.angles;
  Element& e = out.elements[f];
  double objective = 0;
  e.triangleResidual = -kPi;
  for (std::size_t k = 0; k < 3; ++k) {
    const ChartCorner c = cornerOf(f, k);
    const double w = problem.weight[c], distance = x[c] - problem.target[c];
    const auto [sine, cosine] = portable::sinCos(x[c]);
    const double m = y[2 * ((k + 2) % 3) + 1] - y[2 * ((k + 1) % 3) + 1];
    e.hessian[k] = 2 * w - m / (sine * sine);
    if (at.curvature == Curvature::Clamped)
      e.hessian[k] = std::max(e.hessian[k], kMinCurvature * w);
    e.gradient[k] = 2 * w * distance;
    if (at.barrier) {
      e.hessian[k] += at.barrier->dual[c] / x[c];
      e.gradient[k] -= at.barrier->tau / x[c];
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
  for (const ChartVertex v : problem.vertices())
    out.residual[rows.ofVertex[v]] = -problem.angleSum[v];
  for (const ChartCorner c : problem.corners()) {
    const ChartVertex v = problem.vertexOfCorner[c];
    out.residual[rows.ofVertex[v]] += x[c];
    if (!problem.isBoundary[v])
      out.residual[rows.ofVertex[v] + 1] += out.logSine[nextCorner(c)] - out.logSine[prevCorner(c)];
  }
}

}  // namespace

ConstraintRows numberRows(const AngleProblem& problem) {
  ConstraintRows rows;
  rows.ofVertex.resize(problem.vertexCount() + 1);
  std::uint32_t n = 0;
  for (const ChartVertex v : problem.vertices()) {
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
               const LinearizationPoint& at, Linearization& out, ThreadPool* pool) {
  const std::vector<double>& x = at.angles;
  out.elements.resize(problem.triangleCount());
  out.logSine.resize(x.size());
  const std::size_t pieces = pieceCount(problem);
  std::vector<double> objective(pieces, 0);
  parallelFor(pool, pieces, [&](std::size_t i) {
    for (const ChartTriangle f : pieceOf(problem, i))
      objective[i] +=
          linearizeTriangle(problem, gatherRows(problem, rows, at.rowMultipliers, f), f, at, out);
  });
  out.objective = 0;
  for (const double part : objective) out.objective += part;
  out.edgeResidual.assign(problem.edgeCorners.size(), -problem.edgeLimit);
  for (std::size_t i = 0; i < problem.edgeCorners.size(); ++i)
    for (const ChartCorner c : problem.edgeCorners[i]) out.edgeResidual[i] += x[c];
  addResiduals(problem, rows, x, out);
}

double constraintResidual(const AngleProblem& problem, const ConstraintRows& rows,
                          const Linearization& lin, ThreadPool* pool) {
  double worst = largest(
      problem, pool, [&](ChartTriangle f) { return std::abs(lin.elements[f].triangleResidual); });
  for (const ChartVertex v : problem.vertices()) {
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
  return largest(problem, pool, [&](ChartTriangle f) {
    const Element& e = lin.elements[f];
    const std::array<double, 3> z =
        applyTransposedJacobian(e, gatherRows(problem, rows, multipliers.row, f));
    double worst = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const ChartCorner c = cornerOf(f, k);
      double g = e.gradient[k] + z[k] + multipliers.triangle[f];
      if (!problem.edgeOfCorner.empty() && problem.edgeOfCorner[c] != kNone)
        g += multipliers.edge[problem.edgeOfCorner[c]];
      worst = std::max(worst, std::abs(g) * problem.target[c] / 2);
    }
    return worst;
  });
}

}  // namespace abflat
