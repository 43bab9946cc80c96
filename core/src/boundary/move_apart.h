#pragma once

#include "boundary/chart_flattener.h"

namespace abflat {

/// From a layout that is fine but for its boundary, which crosses or touches itself: the layout
/// with the arcs that cross drawn back into the chart by little, compared with the triangles there.
/// That takes no solution. Slits in what is nearly flat close again when they are flattened, and
/// tighter bounds of some vertices only move the place where they do. Not valid where little does
/// not help, or would exceed a bound.
Attempt movedApart(ChartFlattener& flattener, const Attempt& crossing);

}  // namespace abflat
