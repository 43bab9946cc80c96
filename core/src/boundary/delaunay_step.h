#pragma once

#include "boundary/chart_flattener.h"

namespace abflat {

/// The paper's section 7: starting from a finished layout, finds one that also meets condition (9)
/// on every interior edge. If there is none, or if its defects are worse than not being Delaunay
/// (boundary crossings that `untangle` does not remove), the layout stays as it is and `fallbacks`
/// says why. Either way `delaunay` is filled in.
Attempt madeDelaunay(ChartFlattener& flattener, Attempt attempt, Untangle untangle);

}  // namespace abflat
