#include <algorithm>
#include <cmath>

#include "base/portable_math.h"
#include "base/smooth_step.h"
#include "samples/generators.h"
#include "samples/grid.h"

namespace abflat {
namespace {

double fourthPower(double x) { return x * x * (x * x); }

/// A smooth bump: `height` in the given direction, falling off like a Gaussian.
struct Bump {
  double longitude, latitude;      ///< degrees; longitude 0 is the face, latitude 90 the crown
  double height, width, tallness;  ///< of the skull's radius; radians sideways and up
};

// Longitudes grow to the left; each bump off the middle has a twin on the other side.
constexpr Bump kBumps[] = {
    {0, 1, 0.15, 0.11, 0.17},      // bridge of the nose
    {0, -11, 0.22, 0.15, 0.10},    // tip of the nose
    {25, 9, -0.20, 0.19, 0.13},    // eye sockets
    {25, 8, 0.10, 0.11, 0.08},     // eyes
    {0, 25, 0.06, 0.50, 0.11},     // brow
    {36, -12, 0.05, 0.22, 0.18},   // cheeks
    {0, -25, 0.07, 0.17, 0.07},    // upper lip
    {0, -30, -0.06, 0.20, 0.045},  // mouth
    {0, -35, 0.08, 0.16, 0.06},    // lower lip
    {0, -47, 0.30, 0.30, 0.12},    // chin
    {93, 2, 0.30, 0.10, 0.20},     // ears
    {180, 12, 0.14, 0.80, 0.55},   // back of the head
};

constexpr double kNeckRadius = 0.47;
constexpr double kNeckLatitude = -52;  // degrees; below, the skull merges into the neck

double radians(double degrees) { return degrees * kSamplePi / 180; }

double bumpAt(const Bump& bump, double longitude, double latitude) {
  const double up = (latitude - radians(bump.latitude)) / bump.tallness;
  double sum = 0;
  for (double centre : {bump.longitude, -bump.longitude}) {
    const double turn = std::remainder(longitude - radians(centre), 2 * kSamplePi);
    const double sideways = turn * portable::cos(latitude) / bump.width;
    sum += bump.height * portable::exp(-(sideways * sideways + up * up) / 2);
    if (std::remainder(2 * bump.longitude, 360) == 0) break;
  }
  return sum;
}

/// Point of the head in a direction.
Point headAt(double longitude, double latitude) {
  const double level = portable::cos(latitude);
  double radius = 1;
  // Longitudes meet at the crown: bumps fade out there.
  for (const Bump& bump : kBumps)
    radius += level * std::sqrt(level) * bumpAt(bump, longitude, latitude);
  const double neck = smoothStep(radians(kNeckLatitude), radians(-75), latitude);
  // Smooth maximum: the skull above, a column below.
  const double column = kNeckRadius * neck;
  const double flat = std::sqrt(std::sqrt(fourthPower(radius * level) + fourthPower(column)));
  return {0.86 * flat * portable::sin(longitude),
          0.1 * neck - 1.04 * flat * portable::cos(longitude),
          1.2 * radius * portable::sin(latitude) - 0.75 * neck};
}

}  // namespace

PolygonMesh makeHead(double detail) {
  constexpr double kCutLatitude = -72;  // degrees
  RingDisk disk;
  disk.rings = scaledCount(36, detail);
  const auto latitudeAt = [](double r) { return radians(90 - r * (90 - kCutLatitude)); };
  // As many edges along a parallel as make them as long as those of the meridians.
  const double spacing = radians(90 - kCutLatitude) / disk.rings;
  disk.ringSize = [=](double r) {
    const double level = latitudeAt(r) > 0 ? portable::cos(latitudeAt(r))
                                           : std::max(portable::cos(latitudeAt(r)), kNeckRadius);
    return static_cast<unsigned>(std::lround(2 * kSamplePi * level / spacing));
  };
  disk.at = [=](double r, double phi) { return headAt(phi, latitudeAt(r)); };
  disk.isSlit = true;
  return diskMesh(disk);
}

}  // namespace abflat
