#include "solve/interior_point.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/constants.h"
#include "solve/newton_system.h"

namespace abflat {
namespace {

constexpr double kFractionToBoundary = 0.95;
/// The slacks' barrier parameter ends here: bounds are met, and left, almost exactly.
constexpr double kSlackFloor = 1e-9;
/// A step at least this long allows a smaller barrier parameter.
constexpr double kGoodStep = 0.3;
/// Below this constraint residual, and after a full step, the exact Hessian is used.
constexpr double kExactResidual = 1e-6;
/// Angles that meet all constraints exist if their residual halves within a few steps, three as a
/// rule, until it is small. If none exist, it never becomes small.
constexpr std::ptrdiff_t kMostStepsToHalve = 20;

/// The largest step, up to `limit`, that takes at most the given fraction of a positive value.
double shorten(double value, double change, double fraction, double limit) {
  return change < 0 ? std::min(limit, -fraction * value / change) : limit;
}

class InteriorPoint {
 public:
  InteriorPoint(const AngleProblem& problem, NewtonSystem& system,
                const InteriorPointOptions& options)
      : problem_(problem), rows_(system.rows()), system_(system), options_(options) {}

  AngleSolution run() {
    start();
    for (int step = 1; step <= options_.common.maxSteps; ++step) {
      if (!solveStep()) break;
      computeDualSteps();
      const double before = lin_.objective;
      const auto [primal, dual] = stepLengths();
      move(primal, dual);
      const NewtonStep now = measure(primal);
      s_.history.push_back(now);
      if (!std::isfinite(now.constraint) || !std::isfinite(now.gradient)) break;
      if (options_.common.onStep && !options_.common.onStep(now)) {
        s_.isEnded = true;
        break;
      }
      if (isDone(now, before)) {
        s_.converged = true;
        break;
      }
      if (isHopeless()) break;
      lowerBarrier(primal);
    }
    return std::move(s_);
  }

 private:
  void start() {
    s_.barrierFloor = options_.barrierFloor;
    s_.angles = problem_.target.raw();
    for (const ChartTriangle f : problem_.triangles()) {
      double* x = &s_.angles[cornerOf(f, 0)];
      double sum = 0;
      for (int k = 0; k < 3; ++k) sum += x[k] = std::min(x[k], 0.99 * kPi);
      for (int k = 0; k < 3; ++k) x[k] *= kPi / sum;
    }
    s_.multipliers.row.assign(rows_.count(), 0);
    s_.multipliers.triangle.assign(problem_.triangleCount(), 0);
    s_.active.assign(problem_.vertexCount(), 0);
    barrier_.tau = tauSlack_ = 1;
    barrier_.dual.resize(s_.angles.size());
    for (std::size_t c = 0; c < s_.angles.size(); ++c)
      barrier_.dual[c] = barrier_.tau / s_.angles[c];
    linearizeHere();
    bounded_.assign(problem_.vertexCount(), 0);
    slack_.assign(problem_.vertexCount(), 0);
    slackStep_ = compliance_ = slack_;
    for (const ChartVertex v : problem_.vertices()) {
      if (!problem_.isBoundary[v] || !std::isfinite(problem_.angleSum[v])) continue;
      bounded_[v] = 1;
      if (problem_.isStraight[v]) continue;
      slack_[v] = std::max(0.1, -lin_.residual[rows_.ofVertex[v]]);
      multiplier(v) = tauSlack_ / slack_[v];
    }
  }

  /// Equations have no slack.
  bool hasSlack(ChartVertex v) const { return bounded_[v] && !problem_.isStraight[v]; }

  double& multiplier(ChartVertex v) { return s_.multipliers.row[rows_.ofVertex[v]]; }

  bool isNear() const {
    return !s_.history.empty() && s_.history.back().constraint < kExactResidual &&
           s_.history.back().step == 1;
  }

  void linearizeHere() { linearizeHere(isNear() ? Curvature::Exact : Curvature::Clamped); }

  void linearizeHere(Curvature curvature) {
    linearize(problem_, rows_, {s_.angles, s_.multipliers.row, curvature, &barrier_}, lin_,
              options_.common.pool);
  }

  bool solveStep() {
    addSlackTerms();
    if (system_.solve(lin_, bounded_, compliance_, dx_, next_)) return true;
    if (!isNear()) return false;
    // Not every solver can handle an indefinite matrix.
    linearizeHere(Curvature::Clamped);
    addSlackTerms();
    return system_.solve(lin_, bounded_, compliance_, dx_, next_);
  }

  /// g + s + J dx + ds = 0 with ds = tau/mu - (s/mu) mu+ eliminated.
  void addSlackTerms() {
    for (const ChartVertex v : problem_.vertices()) {
      if (!hasSlack(v)) continue;
      compliance_[v] = slack_[v] / multiplier(v);
      lin_.residual[rows_.ofVertex[v]] += slack_[v] + tauSlack_ / multiplier(v);
    }
  }

  void computeDualSteps() {
    dualStep_.resize(dx_.size());
    for (std::size_t c = 0; c < dx_.size(); ++c)
      dualStep_[c] = (barrier_.tau - barrier_.dual[c] * dx_[c]) / s_.angles[c] - barrier_.dual[c];
    for (const ChartVertex v : problem_.vertices())
      if (hasSlack(v))
        slackStep_[v] = tauSlack_ / multiplier(v) - compliance_[v] * next_.row[rows_.ofVertex[v]];
  }

  std::pair<double, double> stepLengths() {
    const double slackFraction = std::max(kFractionToBoundary, 1 - tauSlack_);
    double primal = 1, dual = 1;
    for (std::size_t c = 0; c < dx_.size(); ++c) {
      primal = shorten(s_.angles[c], dx_[c], kFractionToBoundary, primal);
      primal = shorten(kPi - s_.angles[c], -dx_[c], kFractionToBoundary, primal);
      dual = shorten(barrier_.dual[c], dualStep_[c], kFractionToBoundary, dual);
    }
    for (const ChartVertex v : problem_.vertices()) {
      if (!hasSlack(v)) continue;
      primal = shorten(slack_[v], slackStep_[v], slackFraction, primal);
      dual =
          shorten(multiplier(v), next_.row[rows_.ofVertex[v]] - multiplier(v), slackFraction, dual);
    }
    return {primal, dual};
  }

  void move(double primal, double dual) {
    for (std::size_t c = 0; c < dx_.size(); ++c) {
      s_.angles[c] += primal * dx_[c];
      barrier_.dual[c] += dual * dualStep_[c];
    }
    for (const ChartVertex v : problem_.vertices()) {
      slack_[v] += primal * slackStep_[v];
      for (std::uint32_t r = rows_.ofVertex[v]; r < rows_.ofVertex[v + 1]; ++r)
        s_.multipliers.row[r] +=
            (hasSlack(v) ? dual : primal) * (next_.row[r] - s_.multipliers.row[r]);
    }
    for (std::size_t f = 0; f < next_.triangle.size(); ++f)
      s_.multipliers.triangle[f] += primal * (next_.triangle[f] - s_.multipliers.triangle[f]);
  }

  NewtonStep measure(double primal) {
    linearizeHere();
    NewtonStep now;
    now.step = primal;
    now.objective = lin_.objective;
    now.constraint = constraintResidual(problem_, rows_, lin_, options_.common.pool);
    now.gradient = gradientResidual(problem_, rows_, lin_, s_.multipliers, options_.common.pool);
    s_.constraintResidual = now.constraint;
    for (const ChartVertex v : problem_.vertices()) {
      s_.active[v] = bounded_[v] && (problem_.isStraight[v] || multiplier(v) > slack_[v]);
      now.active += s_.active[v];
    }
    return now;
  }

  bool isDone(const NewtonStep& now, double before) const {
    const SolverOptions& o = options_.common;
    return barrier_.tau <= options_.barrierFloor && tauSlack_ <= kSlackFloor && now.step == 1 &&
           now.constraint <= o.constraintTolerance &&
           (now.gradient <= o.gradientTolerance ||
            std::abs(before - now.objective) <= o.objectiveTolerance * before);
  }

  /// Whether there seem to be no angles that meet the constraints.
  bool isHopeless() const {
    if (s_.history.size() <= std::size_t{kMostStepsToHalve}) return false;
    const auto least = [](auto from, auto to) {
      return std::min_element(from, to,
                              [](const NewtonStep& a, const NewtonStep& b) {
                                return a.constraint < b.constraint;
                              })
          ->constraint;
    };
    const auto recent = s_.history.end() - kMostStepsToHalve;
    const double before = least(s_.history.begin(), recent);
    return before > kExactResidual && least(recent, s_.history.end()) > before / 2;
  }

  /// Lowers the barrier with the mean complementarity, faster the longer the steps are.
  void lowerBarrier(double primal) {
    if (primal < kGoodStep) return;
    double sum = 0;
    for (std::size_t c = 0; c < dx_.size(); ++c) sum += s_.angles[c] * barrier_.dual[c];
    const double mean = sum / static_cast<double>(dx_.size());
    barrier_.tau = std::max(options_.barrierFloor, std::min(barrier_.tau, 0.3 * mean));
    const double faster = primal > 0.9 ? std::min(0.1, std::sqrt(tauSlack_)) : 0.3;
    tauSlack_ = std::max(kSlackFloor, faster * tauSlack_);
  }

  const AngleProblem& problem_;
  const ConstraintRows& rows_;
  NewtonSystem& system_;
  const InteriorPointOptions& options_;
  AngleSolution s_;
  Barrier barrier_;
  double tauSlack_ = 1;
  std::vector<std::uint8_t> bounded_;                   ///< vertices with a finite bound
  std::vector<double> slack_, slackStep_, compliance_;  ///< per vertex
  Linearization lin_;
  std::vector<double> dx_, dualStep_;
  Multipliers next_;
};

}  // namespace

AngleSolution solveInteriorPoint(const AngleProblem& problem, NewtonSystem& system,
                                 const InteriorPointOptions& options) {
  return InteriorPoint(problem, system, options).run();
}

}  // namespace abflat
