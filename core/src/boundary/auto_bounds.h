#pragma once

#include <limits>

#include "abflat/generated/flatten_options.h"
#include "boundary/chart_flattener.h"

namespace abflat {

/// What is asked of a layout's outline.
struct OutlineGoal {
  BoundaryBounds t;
  bool isAuto = false;  ///< bounds may be lowered as far as needed to remove a crossing
  Untangle untangle = Untangle::None;
  bool isDelaunay = false;  ///< also asks for condition (9)
};

/// How much untangling may cost.
struct Effort {
  /// Newton steps allowed for each step that the layout with crossings took, and their minimum.
  int stepsPerStep = 20, leastSteps = 200;
  /// A layout with crossings is left alone if it is stretched more than this (as the symmetric
  /// Dirichlet energy / 4).
  double mostStretch = std::numeric_limits<double>::infinity();
  /// A layout that is not valid is an acceptable answer: there are no last resorts, which distort.
  bool mayStayInvalid = false;
};

/// The valid layout with the least distortion under the given bounds: the one for these bounds if
/// it has no crossing, otherwise untangled from there. The attempt's fallbacks say what else was
/// tried if this fails (other bounds, Tutte's embedding).
Attempt flattenAutomatically(ChartFlattener& flattener, const BoundaryBounds& t, Untangle untangle,
                             const Effort& effort = {});

/// The same, starting from the result of flattening under those bounds.
Attempt madeValid(ChartFlattener& flattener, Attempt first, const BoundaryBounds& t,
                  Untangle untangle, const Effort& effort = {});

/// Removes the crossings of an attempt if possible; returns the attempt itself if there are none or
/// if it fails.
Attempt untangled(ChartFlattener& flattener, Attempt attempt, Untangle untangle,
                  const Effort& effort = {});

/// Whether the only defect of a layout is that its boundary crosses itself.
bool isTangled(const Attempt& a);

}  // namespace abflat
