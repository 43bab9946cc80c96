#include "refine/rest_triangles.h"

#include "mesh/triangle_geometry.h"

namespace abflat {
namespace {

/// Of what is no surface, in the mean weight of a triangle.
constexpr double kLittle = 1e-3;

/// A triangle with corners at 0, (length, 0) and (x, height). None where it has no area.
RestTriangle restTriangle(double length, double x, double height, double weight) {
  RestTriangle out;
  const double doubleArea = length * height;
  if (!(doubleArea > 0) || !std::isfinite(1 / doubleArea)) return out;
  out.c1x = 1 / (2 * length);
  out.c1y = -x / (2 * doubleArea);
  out.c2y = 1 / (2 * height);
  out.weight = weight;
  return out;
}

RestTriangle onSurface(const DiskChart& chart, const std::uint32_t* v) {
  const Vec3 a = edgeVector(chart.positions, v[0], v[1]);
  const Vec3 b = edgeVector(chart.positions, v[0], v[2]);
  const double length = norm(a), area = norm(cross(a, b)) / 2;
  return restTriangle(length, dot(a, b) / length, 2 * area / length, area);
}

RestTriangle inLayout(const std::vector<double>& uv, const std::uint32_t* v, double weight) {
  const double *p = &uv[2 * std::size_t{v[0]}], *q = &uv[2 * std::size_t{v[1]}],
               *r = &uv[2 * std::size_t{v[2]}];
  const double ux = q[0] - p[0], uy = q[1] - p[1], vx = r[0] - p[0], vy = r[1] - p[1];
  const double length = norm(ux, uy);
  return restTriangle(length, (ux * vx + uy * vy) / length, (ux * vy - uy * vx) / length, weight);
}

}  // namespace

std::vector<RestTriangle> restTriangles(const DiskChart& chart, const std::vector<double>& uv) {
  std::vector<RestTriangle> out(chart.triangleCount());
  double total = 0;
  const auto corners = [&](std::size_t f) { return &chart.vertexOfCorner[3 * f]; };
  for (std::uint32_t f = 0; f < chart.surfaceTriangles(); ++f) {
    const std::array<double, 3> angles = cornerAngles(chart.positions, corners(f));
    if (!isDegenerate(angles)) out[f] = onSurface(chart, corners(f));
    total += out[f].weight;
  }
  const double little = kLittle * total / static_cast<double>(out.size());
  for (std::size_t f = 0; f < out.size(); ++f) {
    if (out[f].weight == 0) out[f] = inLayout(uv, corners(f), little);
    out[f].weight = total > 0 ? out[f].weight / total : 0;
  }
  return out;
}

}  // namespace abflat
