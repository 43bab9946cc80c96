#pragma once

#include "boundary/chart_flattener.h"

namespace abflat {

/// Bounds between free and convex that leave no crossing, with as little distortion as can be
/// found.
///
/// Both start from `crossing`, a layout whose triangles are fine but whose boundary crosses itself,
/// and return a valid attempt, or one that is not valid when none was found. All tries are
/// warm-started.

/// One limit for the whole boundary, below the bounds it has: the largest, to 0.01, without a
/// crossing. Gives up as soon as the distortion is bound to exceed `distortionLimit`.
Attempt untangleGlobal(ChartFlattener& flattener, const Attempt& crossing, double distortionLimit);

/// Tightens only the vertices of the arcs that cross, a little each time: classic ABF's
/// post-processing with bounds in place of fixed angles. Then relaxes as far as no crossing
/// returns.
Attempt untangleLocal(ChartFlattener& flattener, const Attempt& crossing);

}  // namespace abflat
