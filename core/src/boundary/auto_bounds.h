#pragma once

#include "abflat/flatten.h"
#include "boundary/chart_flattener.h"

namespace abflat {

/// The valid layout with the least distortion under the given bounds: those bounds where that
/// leaves no crossing, otherwise untangled from there. What else was tried when this fails (other
/// bounds, Tutte's embedding) is in the attempt's fallbacks.
Attempt flattenAutomatically(ChartFlattener& flattener, const std::vector<double>& t,
                             Untangle untangle);

/// Removes the crossings of an attempt where it can; returns the attempt itself where there are
/// none or it cannot.
Attempt untangled(ChartFlattener& flattener, Attempt attempt, Untangle untangle);

}  // namespace abflat
