#include <cmath>

#include "samples/generators.h"
#include "samples/grid.h"

namespace abflat {

PolygonMesh makeHemisphere(double detail) {
  return diskMesh(scaledCount(18, detail), [](double r, double phi) -> Point {
    const double theta = r * kSamplePi / 2;
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
  });
}

}  // namespace abflat
