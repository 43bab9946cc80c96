#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "angle/constants.h"

namespace abflat {

using Vec3 = std::array<double, 3>;

inline Vec3 edgeVector(const std::vector<double>& positions, std::uint32_t from, std::uint32_t to) {
  const double* p = &positions[3 * static_cast<std::size_t>(from)];
  const double* q = &positions[3 * static_cast<std::size_t>(to)];
  return {q[0] - p[0], q[1] - p[1], q[2] - p[2]};
}
inline double dot(const Vec3& a, const Vec3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double norm(const Vec3& a) { return std::hypot(a[0], a[1], a[2]); }

/// Interior angles of a triangle in 3D, radians, by atan2 (accurate for needles). All zero when two
/// corners coincide.
inline std::array<double, 3> cornerAngles(const std::vector<double>& positions,
                                          const std::uint32_t* v) {
  std::array<Vec3, 3>
      e;  // unit vectors from corner k to the next: coordinates of any magnitude work
  for (std::size_t k = 0; k < 3; ++k) {
    e[k] = edgeVector(positions, v[k], v[(k + 1) % 3]);
    const double largest = std::max({std::abs(e[k][0]), std::abs(e[k][1]), std::abs(e[k][2])});
    if (!(largest > 0)) return {0, 0, 0};
    for (double& x : e[k]) x /= largest;
    const double length = norm(e[k]);
    for (double& x : e[k]) x /= length;
  }
  std::array<double, 3> angle;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 &a = e[k], &b = e[(k + 2) % 3];
    angle[k] = std::atan2(norm(cross(a, b)), -dot(a, b));
  }
  return angle;
}

/// An angle this small is rounding noise of the coordinates: the triangle is taken to have zero
/// area.
constexpr double kDegenerateAngle = 1e-9;

inline bool isDegenerate(const std::array<double, 3>& angles) {
  return std::min({angles[0], angles[1], angles[2]}) < kDegenerateAngle;
}

/// Smallest angle made up for a triangle of zero area, whose own angles say nothing: small enough
/// to cost its neighbours little, large enough to be drawn.
constexpr double kMadeUpAngle = 1e-3;

inline std::array<double, 3> anglesOrMadeUp(const std::vector<double>& positions,
                                            const std::uint32_t* v) {
  std::array<double, 3> alpha = cornerAngles(positions, v);
  if (!isDegenerate(alpha)) return alpha;
  double sum = 0;
  for (double& a : alpha) sum += a = std::max(a, kMadeUpAngle);
  for (double& a : alpha) a *= kPi / sum;
  return alpha;
}

}  // namespace abflat
