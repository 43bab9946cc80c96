#include "hole/triangulate_rim.h"

#include <algorithm>

#include "base/point2.h"
#include "check/crossings.h"
#include "mesh/clip_ears.h"

namespace abflat {
namespace {

/// Projects onto the plane perpendicular to `normal`; empty if `normal` is zero.
std::vector<Point2> project(const IdVector<RimIndex, Vec3>& points, Vec3 normal) {
  const double length = norm(normal);
  if (!(length > 0)) return {};
  for (double& x : normal) x /= length;
  std::size_t least = 0;  // the axis farthest from the normal
  for (std::size_t d = 1; d < 3; ++d)
    if (std::abs(normal[d]) < std::abs(normal[least])) least = d;
  Vec3 axis{};
  axis[least] = 1;
  Vec3 right = cross(axis, normal);
  const double scale = norm(right);
  for (double& x : right) x /= scale;
  const Vec3 up = cross(normal, right);
  std::vector<Point2> out;
  out.reserve(points.size());
  for (const Vec3& p : points) out.push_back({dot(p, right), dot(p, up)});
  return out;
}

bool isSimple(const std::vector<Point2>& polygon) {
  std::vector<double> flat;
  flat.reserve(2 * polygon.size());
  for (const auto& p : polygon) flat.insert(flat.end(), p.begin(), p.end());
  return findCrossings(flat, 1).count == 0;
}

bool canBeDrawn(const Rim& rim, const std::vector<Point2>& polygon,
                const std::vector<RimTriangle>& triangles) {
  IdVector<RimIndex, std::uint32_t> uses(polygon.size(), 0);
  for (const RimTriangle& t : triangles) {
    if (!(turnOf(polygon[t[0]], polygon[t[1]], polygon[t[2]]) > 0)) return false;
    for (std::size_t k = 0; k < 3; ++k) {
      const RimIndex a = t[k], b = t[(k + 1) % 3];
      ++uses[a];
      const bool isSide = (a + 1) % polygon.size() == b;
      if (!isSide && rim.isJoined(a, b)) return false;
    }
  }
  for (const RimIndex i : uses.ids())
    if (rim.isCorner[i] && uses[i] < 2) return false;
  return true;
}

}  // namespace

std::vector<RimTriangle> triangulateRim(const Rim& rim) {
  if (rim.points.size() < 3) return {};
  const std::vector<Point2> polygon = project(rim.points, areaVector(rim.points.raw()));
  if (polygon.empty() || !isSimple(polygon)) return {};
  std::vector<RimTriangle> triangles;
  for (const auto& [a, b, c] : clipEars(polygon, rim.isCorner.raw()))
    triangles.push_back({RimIndex(a), RimIndex(b), RimIndex(c)});
  if (!canBeDrawn(rim, polygon, triangles)) return {};
  return triangles;
}

}  // namespace abflat
