#include "refine/rest_triangles.h"

#include "mesh/triangle_geometry.h"

namespace abflat {
namespace {

/// Weight of a triangle that is not part of the surface, relative to the mean weight of a triangle.
constexpr double kLittle = 1e-3;

/// A triangle with corners at 0, (length, 0) and (x, height). Left out if it has no area.
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

RestTriangle onSurface(const DiskChart& chart, const TriangleVertices& v) {
  const Vec3 a = edgeVector(chart.positions, v[0], v[1]);
  const Vec3 b = edgeVector(chart.positions, v[0], v[2]);
  const double length = norm(a), area = norm(cross(a, b)) / 2;
  return restTriangle(length, dot(a, b) / length, 2 * area / length, area);
}

RestTriangle inLayout(const std::vector<double>& uv, const TriangleVertices& v, double weight) {
  const auto [p, q, r] = pointsOf(uv, v);
  const double ux = q[0] - p[0], uy = q[1] - p[1], vx = r[0] - p[0], vy = r[1] - p[1];
  const double length = norm(ux, uy);
  return restTriangle(length, (ux * vx + uy * vy) / length, (ux * vy - uy * vx) / length, weight);
}

}  // namespace

RestTriangles restTriangles(const DiskChart& chart, const std::vector<double>& uv) {
  RestTriangles out(chart.triangleCount());
  double total = 0;
  for (const ChartTriangle f : chart.surfaceTriangles()) {
    const TriangleVertices v = verticesOf(chart.vertexOfCorner, f);
    if (!isDegenerate(cornerAngles(chart.positions, v))) out[f] = onSurface(chart, v);
    total += out[f].weight;
  }
  const double little = kLittle * total / static_cast<double>(out.size());
  for (const ChartTriangle f : out.ids()) {
    if (out[f].weight == 0) out[f] = inLayout(uv, verticesOf(chart.vertexOfCorner, f), little);
    out[f].weight = total > 0 ? out[f].weight / total : 0;
  }
  return out;
}

}  // namespace abflat
