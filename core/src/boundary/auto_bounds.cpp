#include "boundary/auto_bounds.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "base/number_text.h"
#include "boundary/move_apart.h"
#include "boundary/untangle.h"

namespace abflat {
namespace {

/// Bounds to try one after another if neither the free boundary nor untangling it gives a valid
/// layout.
constexpr double kLastResorts[] = {1.5, 1.2, 1.0, 1.8};

/// Skips the global search if the arcs' own bounds add no more than this share to the angular
/// distortion of the layout with crossings, below which no layout without crossings can be.
constexpr double kLittleMore = 0.05;

/// Limit on the last resorts, in Newton steps.
constexpr int kLastSteps = 400;

/// Stretched so much that Tutte's embedding may well be better.
bool isRuined(const Attempt& a) {
  constexpr double kRuin = 100;
  return a.distortion.symmetricDirichlet > kRuin;
}

/// Hardly more distortion than with crossings.
bool isCloseTo(const Attempt& a, const Attempt& crossing) {
  constexpr double kHardlyMore = 1e-3;
  return a.distortion.angular <= (1 + kLittleMore) * crossing.distortion.angular ||
         a.distortion.symmetricDirichlet <=
             (1 + kHardlyMore) * crossing.distortion.symmetricDirichlet;
}

std::string givenUp(int steps) {
  return "gave up untangling after " + std::to_string(steps) + " Newton steps";
}

/// The best result of the ways that `untangle` names, or the attempt itself if none works.
Attempt untangledWithin(ChartFlattener& flattener, Attempt attempt, Untangle untangle) {
  const int before = flattener.steps();
  // Another solution, of which untangling needs many, takes far longer.
  constexpr double kDeepest = 0.01;
  Attempt best = movedApart(flattener, attempt, kDeepest);
  bool found = best.valid();
  if (found && isCloseTo(best, attempt)) return best;
  if (untangle != Untangle::Global) {
    Attempt local = untangleLocal(flattener, attempt);
    if (local.isCancelled()) return local;
    const bool isBetter = !found || local.distortion.angular < best.distortion.angular;
    if (local.valid() && isBetter) best = std::move(local);
    found = best.valid();
  }
  const bool isGoodEnough = found && isCloseTo(best, attempt);
  if (untangle != Untangle::Local && !isGoodEnough && !flattener.isSpent()) {
    const double limit = found ? best.distortion.angular : std::numeric_limits<double>::infinity();
    Attempt global = untangleGlobal(flattener, attempt, limit);
    if (global.isCancelled()) return global;
    if (global.valid() && global.distortion.angular < limit) {
      best = std::move(global);
      found = true;
    }
  }
  if (found) return best;
  if (flattener.isSpent()) attempt.fallbacks.push_back(givenUp(flattener.steps() - before));
  return attempt;
}

/// The less stretched of two attempts; one that is not valid does not count.
void keepBetter(std::optional<Attempt>& best, Attempt other) {
  if (!other.valid()) return;
  if (!best || other.distortion.symmetricDirichlet < best->distortion.symmetricDirichlet)
    best = std::move(other);
}

/// Lowers the bounds of all vertices alike until a layout is valid and not ruined. None if no limit
/// gives a valid one.
std::optional<Attempt> lastResort(ChartFlattener& flattener, const BoundaryBounds& t) {
  const ChartFlattener::StepLimit steps(flattener, kLastSteps);
  std::optional<Attempt> best;
  for (const double limit : kLastResorts) {
    BoundaryBounds tighter = t;
    for (double& x : tighter) x = std::min(x, limit);
    Attempt a = flattener.attempt(tighter, nullptr);
    if (a.isCancelled()) return a;
    if (a.isGivenUp()) break;
    a.fallbacks.push_back("no valid layout with a free boundary; lowered all bounds to " +
                          withDigits(limit, 2) + " pi");
    keepBetter(best, std::move(a));
    if (best && !isRuined(*best)) break;
  }
  return best;
}

}  // namespace

bool isTangled(const Attempt& a) {
  return a.validity.crossings.count > 0 && a.validity.flippedTriangles == 0 && a.converged();
}

Attempt untangled(ChartFlattener& flattener, Attempt attempt, Untangle untangle,
                  const Effort& effort) {
  if (untangle == Untangle::None || untangle == Untangle::Auto || attempt.isCancelled() ||
      !isTangled(attempt) || attempt.distortion.symmetricDirichlet > effort.mostStretch)
    return attempt;
  const auto first = static_cast<int>(attempt.solution.history.size());
  const ChartFlattener::StepLimit steps(flattener,
                                        std::max(effort.leastSteps, effort.stepsPerStep * first));
  return untangledWithin(flattener, std::move(attempt), untangle);
}

Attempt flattenAutomatically(ChartFlattener& flattener, const BoundaryBounds& t, Untangle untangle,
                             const Effort& effort) {
  return madeValid(flattener, flattener.attempt(t, nullptr), t, untangle, effort);
}

Attempt madeValid(ChartFlattener& flattener, Attempt first, const BoundaryBounds& t,
                  Untangle untangle, const Effort& effort) {
  if (first.valid() || first.isCancelled()) return first;
  Attempt best = untangled(flattener, std::move(first), untangle, effort);
  if (best.valid() || best.isCancelled()) return best;
  if (effort.mayStayInvalid) return best;
  std::optional<Attempt> last = lastResort(flattener, t);
  if (last && (last->isCancelled() || !isRuined(*last))) return std::move(*last);
  Attempt convex =
      flattener.tutte(t, last ? "the bounds that give a valid layout stretch it beyond use"
                              : "no bounds give a valid layout from angles");
  if (last) {
    keepBetter(last, std::move(convex));
    return std::move(*last);
  }
  // Then angles that miss what was asked for are the lesser evil.
  if (!convex.valid() && best.converged() && best.validity.valid()) return best;
  return convex;
}

}  // namespace abflat
