#pragma once

#include "layout/convex_combination.h"

namespace abflat {

/// Tutte 1963: the boundary on a circle, spaced by edge length, every interior vertex at the mean
/// of its neighbours. A valid embedding for any disk in exact arithmetic. uv, 2 per chart vertex,
/// of the chart's 3D area, lower left corner of the circle's bounding box at the origin.
Embedding embedTutte(const DiskChart& chart);

}  // namespace abflat
