#include "layout/pose.h"

#include <algorithm>
#include <cmath>

#include "base/point2.h"
#include "base/portable_math.h"
#include "mesh/triangle_geometry.h"

namespace abflat {
namespace {

double totalArea(const DiskChart& chart, const std::vector<double>& uv) {
  double area = 0;
  for (const ChartTriangle f : chart.surfaceTriangles()) {
    const auto [a, b, c] = pointsOf(uv, verticesOf(chart.vertexOfCorner, f));
    area += std::abs((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2;
  }
  return area;
}

Point2 center(const std::vector<double>& uv) {
  Point2 sum{0, 0};
  for (std::size_t i = 0; i < uv.size(); ++i) sum[i % 2] += uv[i];
  const double count = static_cast<double>(uv.size()) / 2;
  return {sum[0] / count, sum[1] / count};
}

/// Cosine and sine of the rotation of `uv` onto `model`.
Point2 rotationOnto(const std::vector<double>& model, const std::vector<double>& uv) {
  const auto from = center(uv), to = center(model);
  double re = 0, im = 0;
  for (std::size_t i = 0; i < uv.size(); i += 2) {
    const double x = uv[i] - from[0], y = uv[i + 1] - from[1];
    const double p = model[i] - to[0], q = model[i + 1] - to[1];
    re += x * p + y * q;
    im += x * q - y * p;
  }
  const double length = portable::hypot(re, im);
  if (!(length > 0) || !std::isfinite(length)) return {1, 0};
  return {re / length, im / length};
}

}  // namespace

void fitArea(const DiskChart& chart, std::vector<double>& uv) {
  const double area = totalArea(chart, uv), wanted = surfaceArea(chart);
  if (!(area > 0 && wanted > 0)) return;
  for (double& x : uv) x *= std::sqrt(wanted / area);
}

void pose(const DiskChart& chart, const std::vector<double>& model, std::vector<double>& uv) {
  fitArea(chart, uv);
  const auto [c, s] = model.size() == uv.size() ? rotationOnto(model, uv) : Point2{1, 0};
  Point2 low{INFINITY, INFINITY};
  for (std::size_t i = 0; i < uv.size(); i += 2) {
    const double x = uv[i], y = uv[i + 1];
    uv[i] = c * x - s * y;
    uv[i + 1] = s * x + c * y;
    for (std::size_t d = 0; d < 2; ++d) low[d] = std::min(low[d], uv[i + d]);
  }
  for (std::size_t i = 0; i < uv.size(); ++i) uv[i] -= low[i % 2];
}

}  // namespace abflat
