#include "flatten/planar.h"

#include <cmath>
#include <utility>
#include <vector>

#include "boundary/blamed_arc.h"
#include "boundary/contacts.h"
#include "boundary/move_apart.h"
#include "layout/pose.h"
#include "mesh/triangle_geometry.h"

namespace abflat {
namespace {

/// The unit normal of the chart's plane; none if it is not flat. The area vector of a surface is as
/// long as its area only if all of its triangles lie in one plane.
std::optional<Vec3> normalOf(const DiskChart& chart) {
  constexpr double kFlat = 1e-8;  // a mean square slope of 1.4e-4
  Vec3 sum{};
  double area = 0;
  for (const ChartTriangle f : chart.surfaceTriangles()) {
    const TriangleVertices v = verticesOf(chart.vertexOfCorner, f);
    const Vec3 n =
        cross(edgeVector(chart.positions, v[0], v[1]), edgeVector(chart.positions, v[0], v[2]));
    for (std::size_t d = 0; d < 3; ++d) sum[d] += n[d];
    area += norm(n);
  }
  const double length = norm(sum);
  if (!(area > 0) || length < (1 - kFlat) * area) return std::nullopt;
  return Vec3{sum[0] / length, sum[1] / length, sum[2] / length};
}

/// The direction of the longest edge of the boundary in the plane, so that it lies level.
Vec3 levelDirection(const DiskChart& chart, const Vec3& normal) {
  Vec3 longest{};
  for (const ChartCorner h : chart.boundary) {
    const Vec3 e =
        edgeVector(chart.positions, chart.vertexOfCorner[h], chart.vertexOfCorner[nextCorner(h)]);
    if (norm(e) > norm(longest)) longest = e;
  }
  const double up = dot(longest, normal);
  for (std::size_t d = 0; d < 3; ++d) longest[d] -= up * normal[d];
  const double length = norm(longest);
  for (double& x : longest) x /= length;
  return longest;
}

std::vector<double> projected(const DiskChart& chart, const Vec3& normal) {
  const Vec3 right = levelDirection(chart, normal), up = cross(normal, right);
  std::vector<double> uv;
  uv.reserve(2 * chart.vertexCount());
  for (const ChartVertex v : chart.vertices()) {
    const double* p = &chart.positions[3 * std::size_t{v}];
    const Vec3 at{p[0], p[1], p[2]};
    uv.insert(uv.end(), {dot(at, right), dot(at, up)});
  }
  return uv;
}

void drawBackContacts(const DiskChart& chart, Attempt& a) {
  const auto crossings = [&](const std::vector<double>& uv) {
    Crossings exact = findCrossings(boundaryUv(chart, uv));
    return exact.count > 0 ? exact : findContacts(chart, uv);
  };
  const std::vector<double> turned = turnedAlong(boundaryAngles(chart, a.uv));
  constexpr double kFewCells = 4;
  const MoveLengths lengths{kFewCells * contactCell(chart, a.uv)};
  MovedBack back = moveBack({chart, a.uv, {}, turned}, lengths, a.validity.crossings, crossings);
  if (!back.isApart) return;
  a.uv = back.uv;
  fitArea(chart, a.uv);
  a.validity = checkSeparated(chart, a.uv);
  a.fallbacks.push_back(movedBackNote(back, chart));
}

}  // namespace

std::optional<Attempt> projectPlanar(const DiskChart& chart) {
  const std::optional<Vec3> normal = normalOf(chart);
  if (!normal) return std::nullopt;
  Attempt out;
  out.t.assign(chart.boundary.size(), 2);
  out.solver = Solver::Projection;
  out.uv = projected(chart, *normal);
  pose(chart, {}, out.uv);
  out.validity = checkSeparated(chart, out.uv);
  if (out.validity.flippedTriangles == 0 && out.validity.crossings.count > 0)
    drawBackContacts(chart, out);
  if (!out.valid()) return std::nullopt;
  out.distortion = measureDistortion(chart, out.uv);
  // Walls of a fold that is too thin to show in the area.
  constexpr double kIsometry = 1e-4;
  if (out.distortion.symmetricDirichlet > 1 + kIsometry) return std::nullopt;
  return out;
}

}  // namespace abflat
