#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "base/constants.h"
#include "base/portable_math.h"
#include "mesh/ids.h"

namespace abflat {

using Vec3 = std::array<double, 3>;

/// Positions of a triangle's vertices in a layout.
inline std::array<const double*, 3> pointsOf(const std::vector<double>& uv,
                                             const TriangleVertices& v) {
  return {&uv[2 * std::size_t{v[0]}], &uv[2 * std::size_t{v[1]}], &uv[2 * std::size_t{v[2]}]};
}

inline Vec3 edgeVector(const std::vector<double>& positions, std::uint32_t from, std::uint32_t to) {
  const double* p = &positions[3 * static_cast<std::size_t>(from)];
  const double* q = &positions[3 * static_cast<std::size_t>(to)];
  return {q[0] - p[0], q[1] - p[1], q[2] - p[2]};
}
inline double dot(const Vec3& a, const Vec3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Uses a plain square root if no square can overflow or lose digits, otherwise hypot, which is
/// several times slower.
inline double norm(const Vec3& a) {
  const double square = dot(a, a);
  return square > 1e-280 && square < 1e280 ? std::sqrt(square) : portable::hypot(a[0], a[1], a[2]);
}
inline double norm(double x, double y) {
  const double square = x * x + y * y;
  return square > 1e-280 && square < 1e280 ? std::sqrt(square) : portable::hypot(x, y);
}

/// Unit normal of a triangle, zero if it has no area.
inline Vec3 unitNormal(const std::vector<double>& positions, const TriangleVertices& v) {
  Vec3 n = cross(edgeVector(positions, v[0], v[1]), edgeVector(positions, v[0], v[2]));
  const double length = norm(n);
  for (double& x : n) x = length > 0 ? x / length : 0;
  return n;
}

/// In radians; 0 if one of them is zero.
inline double angleBetween(const Vec3& a, const Vec3& b) {
  return portable::atan2(norm(cross(a, b)), dot(a, b));
}

/// Sum of the cross products of neighbours, seen from the first point: twice the area vector.
inline Vec3 areaVector(const std::vector<Vec3>& p) {
  Vec3 sum{};
  for (std::size_t i = 1; i + 1 < p.size(); ++i) {
    Vec3 a, b;
    for (std::size_t d = 0; d < 3; ++d) {
      a[d] = p[i][d] - p[0][d];
      b[d] = p[i + 1][d] - p[0][d];
    }
    const Vec3 n = cross(a, b);
    for (std::size_t d = 0; d < 3; ++d) sum[d] += n[d];
  }
  return sum;
}

inline double areaOf(const std::vector<double>& positions, const TriangleVertices& v) {
  return norm(cross(edgeVector(positions, v[0], v[1]), edgeVector(positions, v[0], v[2]))) / 2;
}

/// Unit vectors from corner k to the next, for coordinates of any magnitude; false if two corners
/// coincide.
inline bool unitEdges(const std::vector<double>& positions, const TriangleVertices& v,
                      std::array<Vec3, 3>& e) {
  for (std::size_t k = 0; k < 3; ++k) {
    e[k] = edgeVector(positions, v[k], v[(k + 1) % 3]);
    const double largest = std::max({std::abs(e[k][0]), std::abs(e[k][1]), std::abs(e[k][2])});
    if (!(largest > 0)) return false;
    for (double& x : e[k]) x /= largest;
    const double length = norm(e[k]);
    for (double& x : e[k]) x /= length;
  }
  return true;
}

/// Interior angles of a triangle in 3D, radians, by atan2 (accurate for needles). All zero if two
/// corners coincide.
inline std::array<double, 3> cornerAngles(const std::vector<double>& positions,
                                          const TriangleVertices& v) {
  std::array<Vec3, 3> e;
  if (!unitEdges(positions, v, e)) return {0, 0, 0};
  std::array<double, 3> angle;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 &a = e[k], &b = e[(k + 2) % 3];
    angle[k] = portable::atan2(norm(cross(a, b)), -dot(a, b));
  }
  return angle;
}

/// An angle this small is rounding noise of the coordinates, so the triangle is taken to have zero
/// area.
constexpr double kDegenerateAngle = 1e-9;

inline bool isDegenerate(const std::array<double, 3>& angles) {
  return std::min({angles[0], angles[1], angles[2]}) < kDegenerateAngle;
}

/// The same from coordinates; computes angles only if their sines do not settle it.
inline bool isDegenerate(const std::vector<double>& positions, const TriangleVertices& v) {
  constexpr double kSettled = 10 * kDegenerateAngle;  // far above the rounding of a unit vector
  std::array<Vec3, 3> e;
  if (!unitEdges(positions, v, e)) return true;
  double least = 1;
  for (std::size_t k = 0; k < 3; ++k) least = std::min(least, norm(cross(e[k], e[(k + 2) % 3])));
  return least < kSettled && isDegenerate(cornerAngles(positions, v));
}

/// Smallest angle made up for a triangle of zero area, whose own angles mean nothing: small enough
/// to cost its neighbours little, large enough to be drawn.
constexpr double kMadeUpAngle = 1e-3;

/// `alpha`, the angles of the triangle, or substitutes if they mean nothing: the third corner keeps
/// its position along the longest edge but is lifted off it, so that neighbours at the short edges
/// are stretched little.
inline std::array<double, 3> anglesOrMadeUp(const std::vector<double>& positions,
                                            const TriangleVertices& v,
                                            const std::array<double, 3>& alpha) {
  if (!isDegenerate(alpha)) return alpha;
  std::array<double, 3> length;
  for (std::size_t k = 0; k < 3; ++k) length[k] = norm(edgeVector(positions, v[k], v[(k + 1) % 3]));
  const auto p =
      static_cast<std::size_t>(std::max_element(length.begin(), length.end()) - length.begin());
  const std::size_t q = (p + 1) % 3, r = (p + 2) % 3;
  if (!(length[p] > 0)) return {kPi / 3, kPi / 3, kPi / 3};
  const double along = length[r] / (length[r] + length[q]);
  const double height = kMadeUpAngle * std::max(along, 1 - along);
  std::array<double, 3> out;
  out[p] = portable::atan2(height, along);
  out[q] = portable::atan2(height, 1 - along);
  out[r] = kPi - out[p] - out[q];
  return out;
}

inline double cotangent(double angle) { return portable::cos(angle) / portable::sin(angle); }

}  // namespace abflat
