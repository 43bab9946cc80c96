#include "refine/refine.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "check/validity.h"
#include "mesh/triangle_geometry.h"
#include "refine/foreseen_contacts.h"
#include "refine/layout_energy.h"
#include "refine/objective.h"
#include "refine/step_model.h"

namespace abflat {
namespace {

/// Residual of the linear system, relative to the largest entry of the gradient.
constexpr double kLinearTolerance = 1e-2;
/// The same where springs are so stiff that even a small residual goes a long way.
constexpr double kLinearToleranceHeld = 1e-4;
/// Share of the way to the first triangle without area.
constexpr double kShareOfLongest = 0.9;
/// A step that promises to gain more than this share of the energy above that at rest is followed
/// by one of the Far kind.
constexpr double kFar = 0.15;
/// This share of the whole energy counts as much as all of it above that at rest.
constexpr double kShareOfEnergy = 0.025;
/// Ratio of a step's gain to that of the step before: a better one is not expected, and nothing is
/// concluded from a worse one.
constexpr double kFastest = 0.1, kSlowest = 0.5;
/// How often a step may look ahead: each time solves a system.
constexpr int kRounds = 6;
constexpr double kArmijo = 1e-4;
constexpr int kMostHalvings = 40;
/// Relative to the energy: smaller changes are indistinguishable from rounding.
constexpr double kRounding = 1e-10;

/// Has the effect of scaling every layout by `scale`.
RestTriangles scaledDown(RestTriangles rest, double scale) {
  for (RestTriangle& t : rest) {
    t.c1x *= scale;
    t.c1y *= scale;
    t.c2y *= scale;
  }
  return rest;
}

bool isSimple(const DiskChart& chart, const std::vector<double>& uv) {
  return findCrossings(boundaryUv(chart, uv), 1).count == 0;
}

/// Of contacts.
double reachFor(const DiskChart& chart, const std::vector<double>& uv) {
  const double size = std::sqrt(surfaceArea(chart)), least = kContactReachOfTouching * size;
  return BoundaryBarrier(chart, least).energy(uv) > 0 ? least : kContactReach * size;
}

/// A layout that the steps have led to.
struct Place {
  std::vector<double> uv;
  double energy = 0;  ///< the objective's
  bool isSimple = true;
};

struct Direction {
  std::vector<double> step;
  double slope = 0;  ///< of the objective along the step
};

double slopeAlong(const Eigen::VectorXd& gradient, const std::vector<double>& step) {
  double out = 0;
  for (std::size_t i = 0; i < step.size(); ++i) out += gradient.data()[i] * step[i];
  return out;
}

/// The longest step without a flip, at most 1.
double longestWithoutFlip(const Objective& objective, const std::vector<double>& uv,
                          const std::vector<double>& step) {
  const double longest = longestStep(objective.chart, objective.rest, uv, step, 2, objective.pool);
  return std::min(1.0, kShareOfLongest * longest);
}

/// Minimises the model, again with springs where the step would cross something; `foreseen`: null
/// if it need not look ahead. Nothing if that has no solution.
std::optional<Direction> findDirection(const Objective& objective, const Place& place,
                                       const Expansion& at, int maxSolves, StepModel& model,
                                       ForeseenContacts* foreseen) {
  const bool isStiff = foreseen || !objective.springs.isEmpty();
  const double tolerance = isStiff ? kLinearToleranceHeld : kLinearTolerance;
  Direction out;
  const auto minimize = [&] { return model.minimize(at, foreseen, tolerance, out.step); };
  if (foreseen) foreseen->begin(place.uv);
  if (!minimize()) return std::nullopt;
  for (int i = 0; foreseen && i < kRounds && model.solves() < maxSolves; ++i) {
    const double length = longestWithoutFlip(objective, place.uv, out.step);
    if (!foreseen->update(place.uv, out.step, length, length / (1 << i / 2))) break;
    if (!minimize()) return std::nullopt;
  }
  out.slope = slopeAlong(at.gradient, out.step);
  if (!(out.slope < 0) && foreseen) {
    foreseen->clear();  // together the springs push uphill
    if (!minimize()) return std::nullopt;
    out.slope = slopeAlong(at.gradient, out.step);
  }
  if (!(out.slope < 0)) return std::nullopt;
  return out;
}

enum class StepEnd : std::uint8_t { Taken, None, Crosses };

struct StepResult {
  StepEnd end = StepEnd::None;
  bool isFull = false;  ///< not shortened
};

/// Goes along the direction as far as the energy falls enough. Crosses, without having moved, if
/// the boundary would do so for the first time.
StepResult takeStep(const Objective& objective, const Direction& direction, Place& place) {
  double length = longestWithoutFlip(objective, place.uv, direction.step);
  Place next;
  next.uv.resize(place.uv.size());
  for (int i = 0; i < kMostHalvings; ++i, length /= 2) {
    for (std::size_t k = 0; k < place.uv.size(); ++k)
      next.uv[k] = place.uv[k] + length * direction.step[k];
    objective.shape.straighten(next.uv);
    next.energy = objective.at(next.uv);
    if (!(next.energy <= place.energy + kArmijo * length * direction.slope)) continue;
    next.isSimple = isSimple(objective.chart, next.uv);
    if (place.isSimple && !next.isSimple) {
      if (!objective.barrier) return {StepEnd::Crosses};
      continue;
    }
    const bool isLess = next.energy < place.energy, isFull = length == 1;
    place = std::move(next);
    return {isLess ? StepEnd::Taken : StepEnd::None, isFull};
  }
  return {};
}

/// The gain of all steps after the next one, if gains go on shrinking as from the last step to
/// this one. `lastGain`: 0 if unknown.
double remainingGain(double gain, double lastGain) {
  const double rate = std::max(gain / lastGain, kFastest);
  return lastGain > 0 && rate < kSlowest ? gain * rate / (1 - rate) : gain;
}

/// Takes steps from a place until they gain too little.
void takeSteps(const RefineOptions& options, Objective& objective, StepModel& model,
               std::optional<ForeseenContacts>& foreseen, Place& place, Refinement& out) {
  bool isFar = true;    // from the minimum
  double lastGain = 0;  // promised by the last step if that was taken in full
  while (out.steps < options.maxSteps && model.solves() < options.maxSolves &&
         options.listener.tell()) {
    const Expansion at =
        model.expand(objective, place.uv, isFar ? ElementCurvature::Far : ElementCurvature::Near);
    const std::optional<Direction> direction = findDirection(
        objective, place, at, options.maxSolves, model, foreseen ? &*foreseen : nullptr);
    if (!direction) return;
    const double gain = -direction->slope / 2, above = place.energy - Energy::kAtRest;
    isFar = gain > kFar * above;
    const double small = std::min(above, kShareOfEnergy * place.energy);
    const double least = foreseen ? options.leastHeld : 0;
    const bool isLast =
        remainingGain(gain, lastGain) <= options.tolerance * small + least + kRounding;
    const StepResult step = takeStep(objective, *direction, place);
    lastGain = step.isFull ? gain : 0;
    if (step.end == StepEnd::Crosses) {
      const double reach = reachFor(objective.chart, place.uv);
      objective.barrier.emplace(objective.chart, reach);
      if (!foreseen) foreseen.emplace(objective.chart, objective.shape, reach);
      place.energy = objective.at(place.uv);
      out.isHeldApart = true;
      continue;
    }
    out.steps += step.end == StepEnd::Taken;
    out.isConverged = isLast;
    if (isLast || step.end == StepEnd::None) return;
  }
}

}  // namespace

Refinement refine(const DiskChart& chart, std::vector<double> uv, const RefineOptions& options) {
  Objective objective(chart, uv, options);
  StepModel model(objective, anchorsOf(chart, uv, options.isFixed), options);
  std::optional<ForeseenContacts> foreseen;  // where it has to look ahead
  if (!options.outline.isEmpty()) foreseen.emplace(chart, objective.shape, reachFor(chart, uv));

  const double scale = bestScale(chart, objective.rest, objective.energy, uv);
  if (options.isFixed.empty())
    for (double& x : uv) x *= scale;
  else
    objective.rest = scaledDown(std::move(objective.rest), scale);
  objective.shape.straighten(uv);

  Place place;
  place.uv = uv;
  place.energy = objective.at(uv);
  place.isSimple = isSimple(chart, uv);
  Refinement out;
  out.energyBefore = place.energy;
  if (std::isfinite(place.energy)) takeSteps(options, objective, model, foreseen, place, out);
  out.energy = objective.ofLayout(place.uv);
  const bool isBetter =
      (objective.springs.isEmpty() ? out.energy : place.energy) < out.energyBefore;
  if (!isBetter) out.energy = out.energyBefore;
  out.uv = std::move(isBetter ? place.uv : uv);
  out.memory = model.memory();
  return out;
}

double energyOf(const DiskChart& chart, const std::vector<double>& uv, const Energy& energy) {
  const RestTriangles rest = restTriangles(chart, uv);
  const double scale = bestScale(chart, rest, energy, uv);
  return layoutEnergy(chart, scaledDown(rest, scale), energy, uv);
}

double stretchBeforeRefining(double stretch, const Energy& energy) {
  return 1 + (stretch - 1) / energy.shareLeft();
}

}  // namespace abflat
