#include <cmath>

#include "base/portable_math.h"
#include "samples/generators.h"
#include "samples/grid.h"

namespace abflat {

PolygonMesh makeWavyStrip(double detail) {
  constexpr double kLength = 9, kHalfWidth = 0.45, kWaves = 4, kBends = 2.5;
  return rectangleMesh(
      scaledCount(140, detail), scaledCount(10, detail), [](double u, double v) -> Point {
        const double along = 2 * kSamplePi * kWaves * u, across = 2 * v - 1;
        const double sway = 0.55 * portable::sin(2 * kSamplePi * kBends * u);
        // The sides run ahead of each other and wave faster: the band is not developable.
        const double wave = 0.4 * portable::sin(along + 0.7 * across);
        const double ruffle = 0.1 * across * across * portable::sin(3 * along + across);
        return {kLength * u, kHalfWidth * across + sway, wave + ruffle};
      });
}

}  // namespace abflat
