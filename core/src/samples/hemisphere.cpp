#include <cmath>

#include "base/portable_math.h"
#include "samples/generators.h"
#include "samples/grid.h"

namespace abflat {

PolygonMesh makeHemisphere(double detail) {
  RingDisk disk;
  disk.rings = scaledCount(18, detail);
  // 6, 12, 18, ... edges: near equilateral triangles.
  disk.ringSize = [&](double r) { return static_cast<unsigned>(std::lround(6 * r * disk.rings)); };
  disk.at = [](double r, double phi) -> Point {
    const double theta = r * kSamplePi / 2;
    return {portable::sin(theta) * portable::cos(phi), portable::sin(theta) * portable::sin(phi),
            portable::cos(theta)};
  };
  return diskMesh(disk);
}

}  // namespace abflat
