#include <cmath>

#include "base/portable_math.h"
#include "samples/generators.h"
#include "samples/grid.h"

namespace abflat {

PolygonMesh makeAlphaBand(double detail) {
  // The nodal cubic (s^2 - 1, s^3 - s) meets itself at s = -1 and s = 1: an alpha seen from above.
  constexpr double kEnd = 1.32, kWidth = 0.3, kRise = 0.16;
  return rectangleMesh(
      scaledCount(120, detail), scaledCount(8, detail), [](double u, double v) -> Point {
        const double s = kEnd * (2 * u - 1), offset = kWidth * (0.5 - v);
        const double dx = 2 * s, dy = 3 * s * s - 1, length = portable::hypot(dx, dy);
        // (dy, -dx) points to the right of the centre line, out of the loop.
        return {s * s - 1 + offset * dy / length, s * s * s - s - offset * dx / length, kRise * s};
      });
}

}  // namespace abflat
