#pragma once

#include <limits>

#include "abflat/generated/flatten_options.h"
#include "boundary/chart_flattener.h"

namespace abflat {

/// What the outline of a layout is asked for.
struct OutlineGoal {
  BoundaryBounds t;
  bool isAuto = false;  ///< bounds may be lowered, as far as a crossing takes it
  Untangle untangle = Untangle::None;
  bool isDelaunay = false;  ///< condition (9) is asked for as well
};

/// What untangling may cost.
struct Effort {
  /// Newton steps, for each that the layout with crossings took, and at least.
  int stepsPerStep = 20, leastSteps = 200;
  /// A layout with crossings is good enough as an answer: without any try where it is stretched
  /// more than this (as the symmetric Dirichlet energy / 4), otherwise when the steps are used up.
  double mostStretch = std::numeric_limits<double>::infinity();
  bool mayStayTangled = false;
};

/// The valid layout with the least distortion under the given bounds: those bounds where that
/// leaves no crossing, otherwise untangled from there. What else was tried when this fails (other
/// bounds, Tutte's embedding) is in the attempt's fallbacks.
Attempt flattenAutomatically(ChartFlattener& flattener, const BoundaryBounds& t, Untangle untangle,
                             const Effort& effort = {});

/// The same, from what flattening under those bounds gave.
Attempt madeValid(ChartFlattener& flattener, Attempt first, const BoundaryBounds& t,
                  Untangle untangle, const Effort& effort = {});

/// Removes the crossings of an attempt where it can; returns the attempt itself where there are
/// none or it cannot.
Attempt untangled(ChartFlattener& flattener, Attempt attempt, Untangle untangle,
                  const Effort& effort = {});

/// All is well with a layout but that its boundary crosses itself.
bool isTangled(const Attempt& a);

}  // namespace abflat
