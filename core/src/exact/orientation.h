#pragma once

namespace abflat {

/// Sign of the area of triangle a, b, c (2 coordinates each): 1 counter-clockwise, -1 clockwise, 0
/// collinear. Exact for all finite doubles.
int orientation(const double* a, const double* b, const double* c);

}  // namespace abflat
