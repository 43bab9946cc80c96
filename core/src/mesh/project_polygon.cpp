#include "mesh/project_polygon.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mesh/triangle_geometry.h"

namespace abflat {
namespace {

struct Polygon {
  std::vector<Vec3> points;  ///< from the first one, scaled to about unit size
  Vec3 normal{};             ///< twice the area vector
};

Polygon polygonOf(const std::vector<double>& positions, const std::uint32_t* vertices,
                  std::size_t count) {
  const double* origin = &positions[3 * static_cast<std::size_t>(vertices[0])];
  Polygon out;
  out.points.resize(count);
  double size = 0;
  for (std::size_t k = 0; k < count; ++k)
    for (std::size_t d = 0; d < 3; ++d) {
      out.points[k][d] = positions[3 * static_cast<std::size_t>(vertices[k]) + d] - origin[d];
      size = std::max(size, std::abs(out.points[k][d]));
    }
  for (std::size_t k = 0; k < count; ++k) {
    for (double& x : out.points[k])
      if (size > 0) x /= size;
    if (k == 0) continue;
    const Vec3 turn = cross(out.points[k - 1], out.points[k]);
    for (std::size_t d = 0; d < 3; ++d) out.normal[d] += turn[d];
  }
  return out;
}

/// Dropping the coordinate of the largest normal component keeps orientation and convexity.
std::vector<Point2> alongAxis(const Polygon& polygon) {
  const auto& [p, normal] = polygon;
  std::size_t drop = 0;
  for (std::size_t d = 1; d < 3; ++d)
    if (std::abs(normal[d]) > std::abs(normal[drop])) drop = d;
  const bool flip = normal[drop] < 0;
  std::vector<Point2> q(p.size());
  for (std::size_t k = 0; k < p.size(); ++k) {
    q[k] = {p[k][(drop + 1) % 3], p[k][(drop + 2) % 3]};
    if (flip) std::swap(q[k][0], q[k][1]);
  }
  return q;
}

}  // namespace

std::vector<Point2> projectPolygon(const std::vector<double>& positions,
                                   const std::uint32_t* vertices, std::size_t count) {
  return alongAxis(polygonOf(positions, vertices, count));
}

std::vector<Point2> facePolygon(const std::vector<double>& positions, const std::uint32_t* vertices,
                                std::size_t count) {
  const Polygon polygon = polygonOf(positions, vertices, count);
  const Vec3& normal = polygon.normal;
  const double length = norm(normal);
  const auto isZero = [](double x) { return x == 0; };
  // Along an axis nothing is rounded.
  if (!(length > 0) || std::count_if(normal.begin(), normal.end(), isZero) == 2)
    return alongAxis(polygon);
  std::size_t least = 0;
  for (std::size_t d = 1; d < 3; ++d)
    if (std::abs(normal[d]) < std::abs(normal[least])) least = d;
  Vec3 axis{};
  axis[least] = 1;
  Vec3 right = cross(axis, normal);
  const double across = norm(right);
  for (double& x : right) x /= across;
  Vec3 up = cross(normal, right);
  for (double& x : up) x /= length;
  std::vector<Point2> out;
  out.reserve(count);
  for (const Vec3& p : polygon.points) out.push_back({dot(p, right), dot(p, up)});
  return out;
}

}  // namespace abflat
