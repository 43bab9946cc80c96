#include <cmath>

#include "samples/generators.h"
#include "samples/grid.h"

namespace abflat {
namespace {

/// A smooth bump of the radius round a direction: `height` at (x, y, z), falling off like a
/// Gaussian with the given widths (radians) sideways and along the meridian.
struct Bump {
  double longitude, latitude;  ///< degrees; longitude 0 is the face, latitude 90 the crown
  double height, width, tallness;
};

// x to the face, y to the left ear, z up; the radius of the skull is 1.
constexpr Bump kBumps[] = {
    {0, -2, 0.16, 0.10, 0.24},     // bridge of the nose
    {0, -13, 0.20, 0.12, 0.11},    // tip of the nose
    {24, 8, -0.13, 0.17, 0.12},    // eye sockets
    {-24, 8, -0.13, 0.17, 0.12},   //
    {25, 7, 0.07, 0.09, 0.07},     // eyeballs
    {-25, 7, 0.07, 0.09, 0.07},    //
    {0, 21, 0.05, 0.45, 0.10},     // brow
    {35, -12, 0.05, 0.22, 0.18},   // cheeks
    {-35, -12, 0.05, 0.22, 0.18},  //
    {0, -27, 0.07, 0.16, 0.06},    // lips
    {0, -31, -0.05, 0.22, 0.025},  // mouth
    {0, -36, 0.06, 0.14, 0.05},    //
    {0, -50, 0.16, 0.24, 0.13},    // chin
    {92, 0, 0.24, 0.07, 0.20},     // ears
    {-92, 0, 0.24, 0.07, 0.20},    //
    {180, 15, 0.12, 0.8, 0.6},     // back of the head
};

double radians(double degrees) { return degrees * kSamplePi / 180; }

double bumpAt(const Bump& bump, double longitude, double latitude) {
  const double turn = std::remainder(longitude - radians(bump.longitude), 2 * kSamplePi);
  const double sideways = turn * std::cos(latitude) / bump.width;
  const double up = (latitude - radians(bump.latitude)) / bump.tallness;
  return bump.height * std::exp(-(sideways * sideways + up * up) / 2);
}

}  // namespace

PolygonMesh makeHead(double detail) {
  constexpr double kNeckLatitude = -62;  // degrees; the cut
  return diskMesh(scaledCount(25, detail), [](double r, double longitude) -> Point {
    const double latitude = radians(90 - r * (90 - kNeckLatitude));
    // Bumps wider than the crown would tear it: they fade out where longitudes meet.
    const double fade = std::cos(latitude) * std::cos(latitude);
    double radius = 1;
    for (const Bump& bump : kBumps) radius += fade * bumpAt(bump, longitude, latitude);
    const double flat = radius * std::cos(latitude);
    return {1.02 * flat * std::cos(longitude), 0.86 * flat * std::sin(longitude),
            1.22 * radius * std::sin(latitude)};
  });
}

}  // namespace abflat
