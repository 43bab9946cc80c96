#include "solve/active_set.h"

#include <algorithm>
#include <cmath>

#include "angle/constants.h"
#include "stopwatch.h"

namespace abflat {
namespace {

/// Share of the way to the nearest bound of (0, pi) that one step may go.
constexpr double kFractionToBoundary = 0.9;
/// c of the active set's definition: scales radians to multipliers (objective per radian).
constexpr double kActiveScale = 1;
/// Two steps in a row shorter than this: some angles want to be 0 and the method does not get on.
constexpr double kStalledStep = 1e-3;
/// Below this constraint residual the exact Hessian is used.
constexpr double kNearSolution = 0.1;

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

void moveTowards(std::vector<double>& value, const std::vector<double>& target, double step) {
  for (std::size_t i = 0; i < value.size(); ++i) value[i] += step * (target[i] - value[i]);
}

AngleSolution startFrom(const AngleProblem& problem, const ConstraintRows& rows,
                        const AngleSolution* start) {
  AngleSolution s;
  if (start) {
    s.angles = start->angles;
    s.multipliers = start->multipliers;
  } else {
    s.angles = startAngles(problem);
    s.multipliers.row.assign(rows.count(), 0);
    s.multipliers.triangle.assign(problem.triangleCount(), 0);
  }
  s.active.assign(problem.vertexCount(), 0);
  return s;
}

}  // namespace

AngleSolution solveActiveSet(const AngleProblem& problem, NewtonStepSolver& system,
                             const SolverOptions& options, const AngleSolution* start) {
  const ConstraintRows& rows = system.rows();
  AngleSolution s = startFrom(problem, rows, start);
  Linearization lin;
  const auto relinearize = [&] {
    const bool near = !s.history.empty() && s.history.back().constraint < kNearSolution;
    linearize(problem, rows, s.angles, s.multipliers.row, lin,
              near ? Curvature::Exact : Curvature::Clamped);
  };
  relinearize();
  updateActive(problem, rows, lin, s.multipliers.row, s.active);
  s.constraintResidual = constraintResidual(problem, rows, lin);

  std::vector<double> dx;
  Multipliers next;
  for (int step = 1; step <= options.maxSteps; ++step) {
    Stopwatch watch;
    if (!system.step({problem, s.angles, s.multipliers, lin, s.active}, dx, next)) return s;
    NewtonStep now;
    now.linearSeconds = watch.lap();
    now.linearIterations = system.linearIterations();
    now.step = stepLength(s.angles, dx);
    for (std::size_t c = 0; c < dx.size(); ++c) s.angles[c] += now.step * dx[c];
    moveTowards(s.multipliers.row, next.row, now.step);
    moveTowards(s.multipliers.triangle, next.triangle, now.step);

    const double before = lin.objective;
    relinearize();
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
