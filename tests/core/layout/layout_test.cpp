#include "layout/layout.h"

#include <cmath>

#include "base/constants.h"
#include "boundary/chart_flattener.h"
#include "catch.h"
#include "layout/diameter.h"
#include "mesh/triangle_geometry.h"
#include "support/meshes.h"
#include "support/problems.h"

using namespace abflat;
using namespace abflat::test;

namespace {

double distance(const std::vector<double>& p, std::size_t stride, std::size_t a, std::size_t b) {
  double sum = 0;
  for (std::size_t d = 0; d < stride; ++d)
    sum += (p[stride * a + d] - p[stride * b + d]) * (p[stride * a + d] - p[stride * b + d]);
  return std::sqrt(sum);
}

std::vector<double> anglesOf(const DiskChart& chart) {
  std::vector<double> x;
  for (const ChartTriangle f : chart.triangles())
    for (double a : cornerAngles(chart.positions, verticesOf(chart.vertexOfCorner, f)))
      x.push_back(a);
  return x;
}

std::vector<double> solved(const DiskChart& chart, double t) {
  return ChartFlattener(chart, {})
      .attempt(BoundaryBounds(chart.boundary.size(), t), nullptr)
      .solution.angles;
}

}  // namespace

TEST_CASE("a planar mesh is laid out congruent to itself from its own angles") {
  const PolygonMesh mesh = transformed(bumpyGrid(30, 20, 0, 1), 3e-5, {1, 2, 3});
  const DiskChart chart = chartOf(mesh);
  const std::vector<double> uv = layOut(chart, anglesOf(chart));
  const double size = distance(chart.positions, 3, 0, chart.vertexCount() - 1);
  for (std::size_t a = 0; a < chart.vertexCount(); a += 7)
    for (std::size_t b = 0; b < a; b += 5)
      CHECK(distance(uv, 2, a, b) ==
            Approx(distance(chart.positions, 3, a, b)).margin(1e-9 * size));
}

TEST_CASE("the longest diameter is horizontal and the bounding box begins at the origin") {
  const DiskChart chart = chartOf(transformed(bumpyGrid(12, 5, 0, 2), 1, {0, 0, 0}));
  const std::vector<double> uv = layOut(chart, anglesOf(chart));
  std::size_t p = 0, q = 0;
  double longest = 0, lowX = 1e9, lowY = 1e9;
  for (std::size_t a = 0; a < chart.vertexCount(); ++a) {
    lowX = std::min(lowX, uv[2 * a]);
    lowY = std::min(lowY, uv[2 * a + 1]);
    for (std::size_t b = 0; b < a; ++b)
      if (distance(uv, 2, a, b) > longest) longest = distance(uv, 2, p = a, q = b);
  }
  CHECK(std::abs(uv[2 * p + 1] - uv[2 * q + 1]) < 1e-12 * longest);
  CHECK(std::abs(lowX) < 1e-12 * longest);
  CHECK(std::abs(lowY) < 1e-12 * longest);
}

TEST_CASE("edge lengths over many orders of magnitude keep their relative precision") {
  // A fan of similar triangles, each half as large as the one before, like a logarithmic spiral.
  std::vector<double> p{0, 0, 0};
  std::vector<std::uint32_t> t;
  constexpr unsigned kCount = 30;
  for (unsigned i = 0; i <= kCount; ++i) {
    const double r = std::pow(0.5, i), u = 0.2 * i;
    p.insert(p.end(), {r * std::cos(u), r * std::sin(u), 0});
    if (i > 0) t.insert(t.end(), {0, i, i + 1});
  }
  const DiskChart chart = chartOf(makeTriangleMesh(p, t));
  const std::vector<double> uv = layOut(chart, anglesOf(chart));
  for (std::size_t i = 1; i < kCount; ++i)
    CHECK(distance(uv, 2, i, i + 1) ==
          Approx(distance(chart.positions, 3, i, i + 1)).epsilon(1e-6));
}

TEST_CASE("diameter by calipers equals the largest of all distances") {
  std::mt19937 random(1);
  std::normal_distribution<double> gauss;
  for (std::size_t n : {1u, 2u, 3u, 4u, 5u, 50u, 300u})
    for (int repeat = 0; repeat < 20; ++repeat) {
      std::vector<Point2> points(n);
      for (Point2& p : points) p = {gauss(random), 0.1 * gauss(random)};
      if (repeat % 4 == 0)
        for (Point2& p : points) p = {std::round(3 * p[0]), std::round(30 * p[1])};
      double longest = 0;
      for (const Point2& a : points)
        for (const Point2& b : points)
          longest = std::max(longest, std::hypot(a[0] - b[0], a[1] - b[1]));
      const auto [a, b] = diameter(points);
      CHECK(std::hypot(points[a][0] - points[b][0], points[a][1] - points[b][1]) ==
            Approx(longest));
    }
}

TEST_CASE("equal diameters are told apart by index, whatever the rounding") {
  // A regular polygon has many longest diameters; noise the size of rounding must not change the
  // choice.
  std::mt19937 random(3);
  std::uniform_real_distribution<double> noise(-1e-12, 1e-12);
  for (unsigned n : {4u, 6u, 7u, 40u, 41u})
    for (int repeat = 0; repeat < 20; ++repeat) {
      std::vector<Point2> points(n);
      for (unsigned i = 0; i < n; ++i) {
        const double u = 2 * kPi * i / n + repeat;
        points[i] = {std::cos(u) + noise(random), std::sin(u) + noise(random)};
      }
      CHECK(diameter(points) == std::array<std::uint32_t, 2>{0, n / 2});
    }
}

TEST_CASE("a symmetric mesh is laid out the same way after perturbations of rounding size") {
  const PolygonMesh mesh = cone(24, 0.7);
  const auto layout = [](const PolygonMesh& m) {
    const DiskChart chart = chartOf(m);
    return layOut(chart, solved(chart, 1));
  };
  const std::vector<double> wanted = layout(mesh);
  PolygonMesh nudged = mesh;
  for (std::size_t i = 0; i < nudged.positions.size(); ++i)
    nudged.positions[i] *= 1 + static_cast<double>(i % 3) * 1e-13;
  const std::vector<double> got = layout(nudged);
  for (std::size_t i = 0; i < wanted.size(); ++i) CHECK(got[i] == Approx(wanted[i]).margin(1e-9));
}
