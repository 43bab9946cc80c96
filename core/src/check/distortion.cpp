#include "check/distortion.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/portable_math.h"
#include "mesh/triangle_geometry.h"

namespace abflat {
namespace {

struct Triangle {
  double area3d, areaUv;            ///< areaUv is signed
  double firstX, secondX, secondY;  ///< in its own plane: (0,0), (firstX,0), (secondX,secondY)
  std::array<double, 6> uv;
};

Triangle makeTriangle(const DiskChart& chart, const std::vector<double>& uv, ChartTriangle f) {
  const TriangleVertices v = verticesOf(chart.vertexOfCorner, f);
  Triangle t;
  const Vec3 a = edgeVector(chart.positions, v[0], v[1]),
             b = edgeVector(chart.positions, v[0], v[2]);
  t.area3d = norm(cross(a, b)) / 2;
  t.firstX = norm(a);
  t.secondX = dot(a, b) / t.firstX;
  t.secondY = 2 * t.area3d / t.firstX;
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t d = 0; d < 2; ++d) t.uv[2 * k + d] = uv[2 * v[k] + d];
  t.areaUv =
      ((t.uv[2] - t.uv[0]) * (t.uv[5] - t.uv[1]) - (t.uv[3] - t.uv[1]) * (t.uv[4] - t.uv[0])) / 2;
  return t;
}

double sumSquaredAngleErrors(const Triangle& t, const std::array<double, 3>& angles3d) {
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double *o = &t.uv[2 * k], *p = &t.uv[2 * ((k + 1) % 3)], *q = &t.uv[2 * ((k + 2) % 3)];
    const double ux = p[0] - o[0], uy = p[1] - o[1], vx = q[0] - o[0], vy = q[1] - o[1];
    const double angle = portable::atan2(std::abs(ux * vy - uy * vx), ux * vx + uy * vy);
    const double error = (angle - angles3d[k]) / angles3d[k];
    sum += error * error;
  }
  return sum;
}

/// Singular values of the map from the 3D triangle to uv scaled by `scale`, largest first.
std::array<double, 2> singularValues(const Triangle& t, double scale) {
  const double a = (t.uv[2] - t.uv[0]) / t.firstX * scale,
               b = (t.uv[3] - t.uv[1]) / t.firstX * scale;
  const double c = ((t.uv[4] - t.uv[0]) * scale - a * t.secondX) / t.secondY;
  const double d = ((t.uv[5] - t.uv[1]) * scale - b * t.secondX) / t.secondY;
  // s1 + s2 and s1 - s2 as norms of the conformal and anticonformal parts.
  const double sum = norm(a + d, b - c), difference = norm(a - d, b + c);
  const double s1 = (sum + difference) / 2;
  return {s1, s1 > 0 ? std::abs(a * d - b * c) / s1 : 0};
}

/// Whether no texture could show the triangle. Chart units make the extent about 1.
bool isSliver(const DiskChart& chart, ChartTriangle f) {
  constexpr double kLeastHeight = 1e-6;
  const TriangleVertices v = verticesOf(chart.vertexOfCorner, f);
  std::array<Vec3, 3> e;
  double longest = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    e[k] = edgeVector(chart.positions, v[k], v[(k + 1) % 3]);
    longest = std::max(longest, norm(e[k]));
  }
  return norm(cross(e[0], e[1])) < kLeastHeight * longest;
}

/// The triangles that measures count.
std::vector<ChartTriangle> measuredTriangles(const DiskChart& chart) {
  std::vector<ChartTriangle> all, seen;
  for (const ChartTriangle f : chart.surfaceTriangles()) {
    if (isDegenerate(chart.angles[f])) continue;
    all.push_back(f);
    if (!isSliver(chart, f)) seen.push_back(f);
  }
  return seen.empty() ? all : seen;
}

double lengthDistortion(const DiskChart& chart, const std::vector<double>& uv) {
  std::vector<std::array<double, 2>> lengths;
  double sum3d = 0, sumUv = 0;
  for (const ChartCorner h : chart.surfaceCorners()) {
    if (chart.twin[h].exists() && chart.twin[h] < h) continue;
    const ChartVertex a = chart.vertexOfCorner[h], b = chart.vertexOfCorner[nextCorner(h)];
    const double l = norm(edgeVector(chart.positions, a, b));
    const double L = norm(uv[2 * a] - uv[2 * b], uv[2 * a + 1] - uv[2 * b + 1]);
    if (!(l > 0)) continue;
    lengths.push_back({l, L});
    sum3d += l;
    sumUv += L;
  }
  const double s = sum3d / sumUv;
  double sum = 0;
  for (const auto& [l, L] : lengths) sum += (s * L / l - 1) * (s * L / l - 1);
  return lengths.empty() ? 0 : sum / static_cast<double>(lengths.size());
}

}  // namespace

Distortion measureDistortion(const DiskChart& chart, const std::vector<double>& uv) {
  double total3d = 0, totalUv = 0;
  for (const ChartTriangle f : chart.surfaceTriangles()) {
    const Triangle t = makeTriangle(chart, uv, f);
    total3d += t.area3d;
    totalUv += std::abs(t.areaUv);
  }
  const double scale = std::sqrt(total3d / totalUv);
  Distortion out;
  double angular = 0, quasi = 0, stretch = 0, dirichlet = 0, area = 0, areaLog = 0, sheared = 0;
  std::size_t measured = 0;
  out.areaMin = std::numeric_limits<double>::infinity();
  out.areaMax = 0;
  for (const ChartTriangle f : measuredTriangles(chart)) {
    const Triangle t = makeTriangle(chart, uv, f);
    ++measured;
    angular += sumSquaredAngleErrors(t, chart.angles[f]);
    const auto [s1, s2] = singularValues(t, scale);
    const double inverse = 1 / (s1 * s1) + 1 / (s2 * s2);
    area += t.area3d;
    quasi += t.area3d * s1 / s2;
    if (s1 > kSheared * s2) sheared += t.area3d;
    stretch += t.area3d * inverse / 2;
    dirichlet += t.area3d * (s1 * s1 + s2 * s2 + inverse) / 4;
    out.quasiConformalMax = std::max(out.quasiConformalMax, s1 / s2);
    out.stretchLinf = measured == 1 ? 1 / s2 : std::max(out.stretchLinf, 1 / s2);
    const double ratio = scale * scale * t.areaUv / t.area3d;
    areaLog += t.area3d * std::abs(portable::log(std::abs(ratio)));
    out.areaMin = std::min(out.areaMin, ratio);
    out.areaMax = std::max(out.areaMax, ratio);
  }
  if (measured == 0) return {};
  out.angular = angular / (3 * static_cast<double>(measured));
  out.length = lengthDistortion(chart, uv);
  out.quasiConformalMean = quasi / area;
  out.sheared = sheared / area;
  out.stretchL2 = std::sqrt(stretch / area);
  out.symmetricDirichlet = dirichlet / area;
  out.areaLog = areaLog / area;
  return out;
}

}  // namespace abflat
