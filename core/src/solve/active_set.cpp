#include "solve/active_set.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "base/constants.h"
#include "base/stopwatch.h"

namespace abflat {
namespace {

/// Share of the way to the nearest bound of (0, pi) that one step may go.
constexpr double kShareOfRoom = 0.9;
/// c of the active set's definition: scales radians to multipliers (objective per radian).
constexpr double kActiveScale = 1;
/// Several consecutive steps shorter than this mean that some angles tend to 0 and the method makes
/// no progress.
constexpr double kStalledStep = 1e-3;
/// A step shorter than this means that some angles are in the way: their weights are raised.
constexpr double kBlockedStep = 0.1;
/// Growth of the weight of an angle that would leave (0, pi).
constexpr double kHeavier = 1.5;
/// Below this constraint residual the exact Hessian is used.
constexpr double kNearSolution = 0.1;
/// What the linear solve of a step may leave, as a share of what Newton's method leaves anyway.
constexpr double kStepShare = 0.1;

bool hasStalled(const std::vector<NewtonStep>& history, int steps) {
  return history.size() >= static_cast<std::size_t>(steps) &&
         std::all_of(history.end() - steps, history.end(),
                     [](const NewtonStep& taken) { return taken.step < kStalledStep; });
}

std::vector<double> startAngles(const AngleProblem& problem) {
  // Targets round a sharp interior spike may exceed pi.
  constexpr double kMargin = 0.02;
  std::vector<double> x = problem.target.raw();
  for (double& angle : x) angle = std::min(angle, kPi - kMargin);
  return x;
}

/// i is active iff mu_i + c g_i > 0. The multiplier of an inactive constraint is 0 by definition.
/// Equations are always active, with multipliers of either sign. Returns whether anything changed.
bool updateActive(const AngleProblem& problem, const ConstraintRows& rows, const Linearization& lin,
                  AngleSolution& s) {
  bool isChanged = false;
  const auto update = [&](double& multiplier, double residual, std::uint8_t& active) {
    const bool now = multiplier + kActiveScale * residual > 0;
    isChanged |= now != (active != 0);
    active = now;
    if (!now) multiplier = 0;
  };
  for (const ChartVertex v : problem.vertices()) {
    const std::uint32_t r = rows.ofVertex[v];
    if (problem.isStraight[v])
      s.active[v] = 1;
    else if (problem.isBoundary[v])
      update(s.multipliers.row[r], lin.residual[r], s.active[v]);
  }
  for (std::size_t i = 0; i < s.activeEdge.size(); ++i)
    update(s.multipliers.edge[i], lin.edgeResidual[i], s.activeEdge[i]);
  return isChanged;
}

double stepLength(const std::vector<double>& x, const std::vector<double>& dx) {
  double step = 1;
  for (std::size_t c = 0; c < x.size(); ++c) {
    const double room = dx[c] < 0 ? x[c] : kPi - x[c];
    if (step * std::abs(dx[c]) > kShareOfRoom * room) step = kShareOfRoom * room / std::abs(dx[c]);
  }
  return step;
}

/// Positivity (paper, section 6, after classic ABF): raises the weights of angles that the full
/// step would take out of (0, pi). Returns how many there are.
std::uint32_t raiseWeights(const std::vector<double>& x, const std::vector<double>& dx,
                           std::vector<double>& weight) {
  std::uint32_t count = 0;
  for (std::size_t c = 0; c < x.size(); ++c) {
    const double room = dx[c] < 0 ? x[c] : kPi - x[c];
    if (std::abs(dx[c]) <= kShareOfRoom * room) continue;
    weight[c] *= kHeavier;
    ++count;
  }
  return count;
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
  s.multipliers.edge.resize(problem.edgeCorners.size(), 0);
  s.active.assign(problem.vertexCount(), 0);
  s.activeEdge.assign(problem.edgeCorners.size(), 0);
  return s;
}

class ActiveSet {
 public:
  ActiveSet(const AngleProblem& problem, NewtonStepSolver& system, const SolverOptions& options)
      : original_(problem), system_(system), options_(options) {}

  AngleSolution run(const AngleSolution* start) {
    s_ = startFrom(problem(), rows(), start);
    relinearize();
    updateActive(problem(), rows(), lin_, s_);
    s_.constraintResidual = constraintResidual(problem(), rows(), lin_, options_.pool);
    for (int step = 1; step <= options_.maxSteps; ++step) {
      if (!takeStep()) break;
      if (options_.onStep && !options_.onStep(s_.history.back())) {
        s_.isEnded = true;
        return std::move(s_);
      }
      if (s_.converged && !raised_) return std::move(s_);
      if (s_.converged) tryOriginalWeights();
      if (hasStalled(s_.history, options_.stalledSteps)) break;
    }
    return heavier_ ? withHistory(std::move(*heavier_)) : std::move(s_);
  }

 private:
  const AngleProblem& problem() const { return raised_ ? *raised_ : original_; }
  const ConstraintRows& rows() const { return system_.rows(); }

  bool isNear() const {
    return !s_.history.empty() && s_.history.back().constraint < kNearSolution;
  }

  void relinearize() { relinearize(isNear() ? Curvature::Exact : Curvature::Clamped); }

  void relinearize(Curvature curvature) {
    linearize(problem(), rows(), {s_.angles, s_.multipliers.row, curvature}, lin_, options_.pool);
    for (std::size_t i = 0; i < s_.multipliers.edge.size(); ++i)
      lin_.edgeResidual[i] -= problem().edgeCompliance * s_.multipliers.edge[i];
  }

  /// However exact the step, Newton's method leaves about the square of the residual.
  double stepTolerance() const {
    const double residual = s_.constraintResidual;
    return std::max(kStepShare * std::min(residual * residual, kStepShare * residual),
                    kStepShare * options_.constraintTolerance);
  }

  bool solveStep() {
    const auto solve = [&] {
      return system_.step(
          {problem(), s_.angles, s_.multipliers, lin_, s_.active, s_.activeEdge, stepTolerance()},
          dx_, next_);
    };
    if (solve()) return true;
    if (!isNear()) return false;
    // Not every solver can handle an indefinite matrix.
    relinearize(Curvature::Clamped);
    return solve();
  }

  /// False if the iteration cannot go on.
  bool takeStep() {
    Stopwatch watch;
    if (!solveStep()) return false;
    NewtonStep now;
    now.linearSeconds = watch.lap();
    now.linearIterations = system_.linearIterations();
    now.step = stepLength(s_.angles, dx_);
    if (now.step < kBlockedStep) {
      if (heavier_) return false;
      if (!raised_) raised_ = original_;
      now.reweighted = raiseWeights(s_.angles, dx_, raised_->weight.raw());
    }
    for (std::size_t c = 0; c < dx_.size(); ++c) s_.angles[c] += now.step * dx_[c];
    moveTowards(s_.multipliers.row, next_.row, now.step);
    moveTowards(s_.multipliers.triangle, next_.triangle, now.step);
    moveTowards(s_.multipliers.edge, next_.edge, now.step);

    const double before = lin_.objective;
    relinearize();
    const bool isActiveChanged = updateActive(problem(), rows(), lin_, s_);
    for (const std::uint8_t active : s_.active) now.active += active;
    for (const std::uint8_t active : s_.activeEdge) now.activeEdges += active;
    now.objective = lin_.objective;
    now.constraint = s_.constraintResidual =
        constraintResidual(problem(), rows(), lin_, options_.pool);
    now.gradient = gradientResidual(problem(), rows(), lin_, s_.multipliers, options_.pool);
    s_.history.push_back(now);
    s_.converged = now.constraint <= options_.constraintTolerance && !isActiveChanged &&
                   (now.gradient <= options_.gradientTolerance ||
                    std::abs(before - now.objective) <= options_.objectiveTolerance * before);
    return std::isfinite(now.constraint) && std::isfinite(now.gradient);
  }

  /// The optimum for the raised weights is known: it is kept, and from there the way to the optimum
  /// for the original weights may be free.
  void tryOriginalWeights() {
    s_.weight = std::move(raised_->weight.raw());
    raised_.reset();
    heavier_ = std::make_unique<AngleSolution>(s_);
    s_.weight.clear();
    s_.converged = false;
    relinearize();
  }

  AngleSolution withHistory(AngleSolution solution) {
    solution.history = std::move(s_.history);
    return solution;
  }

  const AngleProblem& original_;
  std::optional<AngleProblem> raised_;  ///< with raised weights
  NewtonStepSolver& system_;
  const SolverOptions& options_;
  AngleSolution s_;
  std::unique_ptr<AngleSolution> heavier_;  ///< converged with raised weights
  Linearization lin_;
  std::vector<double> dx_;
  Multipliers next_;
};

}  // namespace

AngleSolution solveActiveSet(const AngleProblem& problem, NewtonStepSolver& system,
                             const SolverOptions& options, const AngleSolution* start) {
  return ActiveSet(problem, system, options).run(start);
}

}  // namespace abflat
