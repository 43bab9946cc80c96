#pragma once

namespace abflat {

/// 1 when d lies inside the circle through a, b, c (2 coordinates each, counter-clockwise), -1
/// outside, 0 on it. Exact for all finite doubles whose products of four neither overflow nor
/// underflow.
int inCircle(const double* a, const double* b, const double* c, const double* d);

}  // namespace abflat
