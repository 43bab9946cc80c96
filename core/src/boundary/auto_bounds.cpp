#include "boundary/auto_bounds.h"

#include <algorithm>
#include <limits>
#include <string>

#include "boundary/untangle.h"

namespace abflat {
namespace {

/// Bounds to try one after another when neither the free boundary nor untangling it gives a valid
/// layout.
constexpr double kLastResorts[] = {1.5, 1.2, 1.0, 1.8};

bool isTangled(const Attempt& a) {
  return a.validity.crossings.count > 0 && a.validity.flippedTriangles == 0 && a.solution.converged;
}

}  // namespace

Attempt untangled(ChartFlattener& flattener, Attempt attempt, Untangle untangle) {
  if (untangle == Untangle::None || untangle == Untangle::Auto || attempt.solution.cancelled ||
      !isTangled(attempt))
    return attempt;
  Attempt best;
  bool found = false;
  if (untangle != Untangle::Global) {
    Attempt local = untangleLocal(flattener, attempt);
    if (local.solution.cancelled) return local;
    if ((found = local.valid())) best = std::move(local);
  }
  if (untangle != Untangle::Local) {
    const double limit = found ? best.distortion.angular : std::numeric_limits<double>::infinity();
    Attempt global = untangleGlobal(flattener, attempt, limit);
    if (global.solution.cancelled) return global;
    if (global.valid() && global.distortion.angular < limit) {
      best = std::move(global);
      found = true;
    }
  }
  return found ? best : attempt;
}

Attempt flattenAutomatically(ChartFlattener& flattener, const std::vector<double>& t,
                             Untangle untangle) {
  Attempt first = flattener.attempt(t, nullptr);
  if (first.valid() || first.solution.cancelled) return first;
  Attempt best = untangled(flattener, std::move(first), untangle);
  if (best.valid() || best.solution.cancelled) return best;
  for (const double limit : kLastResorts) {
    std::vector<double> tighter = t;
    for (double& x : tighter) x = std::min(x, limit);
    Attempt a = flattener.attempt(tighter, nullptr);
    if (a.solution.cancelled) return a;
    if (!a.valid()) continue;
    a.fallbacks.push_back("no valid layout with the free boundary; all bounds lowered to " +
                          std::to_string(limit).substr(0, 3) + " pi");
    return a;
  }
  return flattener.tutte("no bounds give a valid layout by angles");
}

}  // namespace abflat
