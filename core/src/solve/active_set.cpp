#include "solve/active_set.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>

#include "angle/constants.h"
#include "solve/schur_system.h"

namespace abflat {
namespace {

/// Share of the way to the nearest bound of (0, pi) that one step may go.
constexpr double kFractionToBoundary = 0.9;
/// c of the active set's definition: scales radians to multipliers (objective per radian).
constexpr double kActiveScale = 1;
/// Two steps in a row shorter than this: some angles want to be 0 and the method does not get on.
constexpr double kStalledStep = 1e-3;

bool hasStalled(const std::vector<NewtonStep>& history) {
  const std::size_t n = history.size();
  return n >= 2 && history[n - 1].step < kStalledStep && history[n - 2].step < kStalledStep;
}

std::vector<double> startAngles(const AngleProblem& problem) {
  // Targets round a sharp interior spike may be beyond pi.
  constexpr double kMargin = 0.02;
  std::vector<double> x = problem.target;
  for (double& angle : x) angle = std::min(angle, kPi - kMargin);
  return x;
}

/// i is active iff mu_i + c g_i > 0.
void updateActive(const AngleProblem& problem, const ConstraintRows& rows, const Linearization& lin,
                  const std::vector<double>& multipliers, std::vector<std::uint8_t>& active) {
  for (std::uint32_t v = 0; v < problem.vertexCount(); ++v) {
    const std::uint32_t r = rows.ofVertex[v];
    active[v] = problem.isBoundary[v] && multipliers[r] + kActiveScale * lin.residual[r] > 0;
  }
}

double stepLength(const std::vector<double>& x, const std::vector<double>& dx) {
  double step = 1;
  for (std::size_t c = 0; c < x.size(); ++c) {
    const double room = dx[c] < 0 ? x[c] : kPi - x[c];
    if (step * std::abs(dx[c]) > kFractionToBoundary * room)
      step = kFractionToBoundary * room / std::abs(dx[c]);
  }
  return step;
}

}  // namespace

AngleSolution solveActiveSet(const AngleProblem& problem, const ActiveSetOptions& options) {
  AngleSolution s;
  const ConstraintRows rows = numberRows(problem);
  s.angles = startAngles(problem);
  s.multipliers.row.assign(rows.count(), 0);
  s.multipliers.triangle.assign(problem.triangleCount(), 0);
  s.active.assign(problem.vertexCount(), 0);

  SchurSystem system(problem, rows);
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor;
  factor.analyzePattern(system.matrix());

  Linearization lin;
  linearize(problem, rows, s.angles, s.multipliers.row, lin);
  updateActive(problem, rows, lin, s.multipliers.row, s.active);
  s.constraintResidual = constraintResidual(problem, rows, lin);

  std::vector<double> dx, triangle, row(rows.count());
  for (int step = 1; step <= options.maxSteps; ++step) {
    system.assemble(lin, s.active);
    factor.factorize(system.matrix());
    if (factor.info() != Eigen::Success) return s;
    const Eigen::VectorXd solved = factor.solve(system.rightHandSide());
    std::copy(solved.begin(), solved.end(), row.begin());
    system.backSubstitute(lin, row, dx, triangle);

    NewtonStep now;
    now.step = stepLength(s.angles, dx);
    for (std::size_t c = 0; c < dx.size(); ++c) s.angles[c] += now.step * dx[c];
    for (std::size_t r = 0; r < row.size(); ++r)
      s.multipliers.row[r] += now.step * (row[r] - s.multipliers.row[r]);
    for (std::size_t f = 0; f < triangle.size(); ++f)
      s.multipliers.triangle[f] += now.step * (triangle[f] - s.multipliers.triangle[f]);

    const double before = lin.objective;
    linearize(problem, rows, s.angles, s.multipliers.row, lin);
    const std::vector<std::uint8_t> previous = s.active;
    updateActive(problem, rows, lin, s.multipliers.row, s.active);
    for (std::uint32_t v = 0; v < problem.vertexCount(); ++v) {
      now.active += s.active[v];
      // The multiplier of an inactive constraint is 0 by definition.
      if (problem.isBoundary[v] && !s.active[v]) s.multipliers.row[rows.ofVertex[v]] = 0;
    }
    now.objective = lin.objective;
    now.constraint = s.constraintResidual = constraintResidual(problem, rows, lin);
    now.gradient = gradientResidual(problem, rows, lin, s.multipliers);
    s.history.push_back(now);
    if (!std::isfinite(now.constraint) || !std::isfinite(now.gradient)) return s;
    if (options.onStep && !options.onStep(step, now)) {
      s.cancelled = true;
      return s;
    }
    s.converged = now.constraint <= options.constraintTolerance && s.active == previous &&
                  (now.gradient <= options.gradientTolerance ||
                   std::abs(before - now.objective) <= options.objectiveTolerance * before);
    if (s.converged || hasStalled(s.history)) return s;
  }
  return s;
}

}  // namespace abflat
