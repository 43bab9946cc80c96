#pragma once

#include "boundary/chart_flattener.h"

namespace abflat {

/// Takes a layout whose only defect is that its boundary crosses or touches itself, and draws the
/// arcs that cross back into the chart, by little compared with the triangles there. That needs no
/// solution. Slits in nearly flat parts close again when they are flattened, and tighter bounds on
/// some vertices only move the place where they do. The result is not valid if a small move does
/// not help, or would exceed a bound.
Attempt movedApart(ChartFlattener& flattener, const Attempt& crossing);

}  // namespace abflat
