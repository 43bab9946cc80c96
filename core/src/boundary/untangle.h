#pragma once

#include "boundary/chart_flattener.h"

namespace abflat {

/// Finds bounds between free and convex that leave no crossing, with as little distortion as
/// possible.
///
/// Both functions start from `crossing`, a layout whose triangles are fine but whose boundary
/// crosses itself. They return a valid attempt, or an invalid one if none was found. All tries are
/// warm-started.

/// Searches a single limit for the whole boundary, below its existing bounds: the largest one, to
/// 0.01, without a crossing. Gives up as soon as the distortion is bound to exceed
/// `distortionLimit`.
Attempt untangleGlobal(ChartFlattener& flattener, const Attempt& crossing, double distortionLimit);

/// Tightens only the vertices of the arcs that cross, a little each time, like classic ABF's
/// post-processing but with bounds in place of fixed angles. Then relaxes the bounds as far as no
/// crossing returns.
Attempt untangleLocal(ChartFlattener& flattener, const Attempt& crossing);

}  // namespace abflat
