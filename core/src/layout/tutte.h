#pragma once

#include "layout/convex_combination.h"

namespace abflat {

/// Tutte 1963: the boundary on a circle, spaced by edge length, every interior vertex at the mean
/// of its neighbours. A valid embedding for any disk in exact arithmetic. uv, 2 per chart vertex,
/// in a circle of the chart's 3D area, lower left corner of the circle's bounding box at the
/// origin.
Embedding embedTutte(const DiskChart& chart);

/// The same with straight runs along chords of the circle. Valid in exact arithmetic unless an edge
/// cuts off part of a run, see flatChords(). Triangles between two parts of a run shrink with each
/// row away from the circle: the lighter edges to the boundary are (1: like others), the less.
Embedding embedTutte(const DiskChart& chart, const StraightPlaces& straight, double boundaryWeight);

}  // namespace abflat
