#include "boundary/move_apart.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "abflat/unwrap.h"
#include "base/constants.h"
#include "base/portable_math.h"
#include "boundary/carry_along.h"
#include "catch.h"
#include "mesh/triangle_geometry.h"
#include "support/instrumented.h"
#include "support/meshes.h"
#include "support/problems.h"

using namespace abflat;
using namespace abflat::test;

namespace {

/// A flat grid, cut open from the middle of its lower side up to the middle along a wave.
PolygonMesh slitSheet(unsigned n, double wave = 0.1) {
  PolygonMesh mesh;
  const auto add = [&](double x, double y) {
    mesh.positions.insert(mesh.positions.end(), {x, y, 0});
    return static_cast<std::uint32_t>(mesh.vertexCount() - 1);
  };
  std::vector<std::vector<std::uint32_t>> at(n + 1, std::vector<std::uint32_t>(n + 1));
  for (unsigned i = 0; i <= n; ++i)
    for (unsigned j = 0; j <= n; ++j) at[i][j] = add(i + wave * std::sin(j), j);
  std::vector<std::uint32_t> right(n + 1);
  for (unsigned j = 0; j < n / 2; ++j) right[j] = add(n / 2 + wave * std::sin(j), j);
  for (unsigned i = 0; i < n; ++i)
    for (unsigned j = 0; j < n; ++j) {
      const auto left = [&](unsigned y) { return i == n / 2 && y < n / 2 ? right[y] : at[i][y]; };
      mesh.faceVertices.insert(mesh.faceVertices.end(), {left(j), at[i + 1][j], at[i + 1][j + 1],
                                                         left(j), at[i + 1][j + 1], left(j + 1)});
    }
  for (std::uint32_t c = 0; c <= mesh.faceVertices.size(); c += 3) mesh.faceOffsets.push_back(c);
  return mesh;
}

/// A plane with towers on it, as in city models.
PolygonMesh city(unsigned m, unsigned height) {
  PolygonMesh mesh;
  const unsigned n = 3 * m + 1;
  std::vector<std::uint32_t> number((n + 1) * (n + 1) * (height + 1), kNone);
  const auto at = [&](unsigned x, unsigned y, unsigned z) {
    std::uint32_t& v = number[(x * (n + 1) + y) * (height + 1) + z];
    if (v == kNone) {
      v = static_cast<std::uint32_t>(mesh.vertexCount());
      for (const unsigned p : {x, y, z}) mesh.positions.push_back(p);
    }
    return v;
  };
  mesh.faceOffsets.push_back(0);
  const auto face = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    mesh.faceVertices.insert(mesh.faceVertices.end(), {a, b, c, d});
    mesh.faceOffsets.push_back(static_cast<std::uint32_t>(mesh.faceVertices.size()));
  };
  for (unsigned i = 0; i < n; ++i)
    for (unsigned j = 0; j < n; ++j) {
      const bool isTower = i % 3 == 1 && j % 3 == 1;
      const unsigned x[] = {i, i + 1, i + 1, i}, y[] = {j, j, j + 1, j + 1};
      for (unsigned z = 0; isTower && z < height; ++z)
        for (unsigned a = 0, b = 1; a < 4; ++a, b = (a + 1) % 4)
          face(at(x[a], y[a], z), at(x[b], y[b], z), at(x[b], y[b], z + 1), at(x[a], y[a], z + 1));
      const unsigned top = isTower ? height : 0;
      face(at(x[0], y[0], top), at(x[1], y[1], top), at(x[2], y[2], top), at(x[3], y[3], top));
    }
  return mesh;
}

double areaUv(const DiskChart& chart, const std::vector<double>& uv) {
  double sum = 0;
  for (const ChartTriangle f : chart.triangles()) {
    const auto [a, b, c] = pointsOf(uv, verticesOf(chart.vertexOfCorner, f));
    sum += ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2;
  }
  return sum;
}

/// The result, and the number of calls while charts are solved: one for each Newton step and for
/// each piece of work of a few milliseconds.
struct Counted {
  int steps = 0;
  int firstSteps = 0;  ///< before any chart is done
  UnwrapReport report;
};

Counted unwrapped(const PolygonMesh& mesh) {
  Counted out;
  double begin = 0;
  UnwrapOptions options;
  options.threads = 1;
  options.balance = 0;  // refining has its own steps
  options.maxStretch = 1.04;
  options.minUtilization = 0;
  options.progress = [&](const Progress& now) {
    if (now.stage != Stage::Solve) return true;
    if (out.steps++ == 0) begin = now.fraction;
    out.firstSteps += now.fraction == begin;
    return true;
  };
  Result<UnwrapResult> r = unwrap(mesh, options);
  INFO(r.status().message);
  REQUIRE(r.ok());
  out.report = std::move(r.value().report);
  return out;
}

const LayoutDemands kSeparated{true, {}, {}};

}  // namespace

TEST_CASE("a slit that closes again is opened without another solution") {
  for (const unsigned n : {6u, 20u, 60u}) {
    const DiskChart chart = chartOf(slitSheet(n));
    ChartFlattener flattener(chart, {}, kSeparated);
    const Attempt closed = flattener.attempt(BoundaryBounds(chart.boundary.size(), 2), nullptr);
    REQUIRE(closed.validity.crossings.count > 0);
    const int steps = flattener.steps();
    const Attempt open = movedApart(flattener, closed);
    CHECK(flattener.steps() == steps);
    CHECK(open.valid());
    CHECK(checkSeparated(chart, open.uv).valid());
    CHECK(open.distortion.symmetricDirichlet < 1 + 1e-4);
    REQUIRE(open.fallbacks.size() == 1);
    CHECK(open.fallbacks.front().find("pulled back") != std::string::npos);
    double farthest = 0;
    for (std::size_t i = 0; i < open.uv.size(); ++i)
      farthest = std::max(farthest, std::abs(open.uv[i] - closed.uv[i]));
    CHECK(farthest > 0);
    CHECK(farthest <= 8 * flattener.leastDistance(closed.uv));
  }
}

namespace {

/// The way out of the chart at each place.
IdVector<BoundaryIndex, Point2> outwards(const DiskChart& chart, const std::vector<double>& uv) {
  IdVector<BoundaryIndex, Point2> out;
  for (const BoundaryIndex k : chart.boundary.ids()) {
    const Point2 a = pointAt(uv, chart.boundaryVertex(chart.before(k)));
    const Point2 b = pointAt(uv, chart.boundaryVertex(chart.after(k)));
    const double x = b[0] - a[0], y = b[1] - a[1], length = portable::hypot(x, y);
    out.push_back({y / length, -x / length});
  }
  return out;
}

/// Moves the middle of the right side of the slit that far over the left side.
std::vector<double> overlapping(const DiskChart& chart, const std::vector<double>& uv, unsigned n,
                                double steps) {
  IdVector<BoundaryIndex, double> shift;
  for (const BoundaryIndex k : chart.boundary.ids()) {
    const std::uint32_t j = chart.inputVertex[chart.boundaryVertex(k)] - (n + 1) * (n + 1);
    const bool isMiddle = j >= n / 8 && j <= 3 * n / 8;
    shift.push_back(isMiddle ? steps / chart.unit : 0);
  }
  return carriedAlong(chart, uv, shift, outwards(chart, uv));
}

}  // namespace

TEST_CASE("what lies around moved places goes along without turning over") {
  const unsigned n = 64;
  const DiskChart chart = chartOf(slitSheet(n));
  const std::vector<double> uv = ChartFlattener(chart, {}, kSeparated)
                                     .attempt(BoundaryBounds(chart.boundary.size(), 2), nullptr)
                                     .uv;
  for (const double steps : {0.5, 2.0, 6.0}) {
    const std::vector<double> moved = overlapping(chart, uv, n, steps);
    CHECK(checkValidity(chart, moved).flippedTriangles == 0);
    double farthest = 0;
    double count = 0;
    for (const ChartVertex v : chart.vertices()) {
      const Point2 a = pointAt(uv, v), b = pointAt(moved, v);
      const double length = portable::hypot(b[0] - a[0], b[1] - a[1]) * chart.unit;
      farthest = std::max(farthest, length);
      if (length > 0) ++count;
    }
    CHECK(farthest == Approx(steps));
    // Not farther around than five times as far.
    CHECK(count < (n / 4 + 2 + 10 * steps) * (5 * steps + 1));
  }
}

TEST_CASE("sides that lie over each other by more than a triangle are drawn apart as asked") {
  const unsigned n = 64;
  const DiskChart chart = chartOf(slitSheet(n));
  for (const double steps : {0.6, 2.0}) {
    ChartFlattener flattener(chart, {}, kSeparated);
    Attempt crossing = flattener.attempt(BoundaryBounds(chart.boundary.size(), 2), nullptr);
    crossing.uv = overlapping(chart, crossing.uv, n, steps);
    flattener.measure(crossing);
    REQUIRE(crossing.validity.flippedTriangles == 0);
    REQUIRE(crossing.validity.crossings.count > 0);
    CHECK_FALSE(movedApart(flattener, crossing).valid());
    const int before = flattener.steps();
    const Attempt apart = movedApart(flattener, crossing, 0.05);
    CHECK(flattener.steps() == before);
    CHECK(apart.valid());
    CHECK(checkSeparated(chart, apart.uv).valid());
    CHECK(areaUv(chart, apart.uv) == Approx(surfaceArea(chart)).epsilon(1e-12));
    // Nor where that is farther than allowed.
    CHECK_FALSE(movedApart(flattener, crossing, 1e-4).valid());
  }
}

TEST_CASE("bounds and straight runs are not given up to draw a boundary back") {
  const DiskChart chart = chartOf(slitSheet(20));
  const std::size_t n = chart.boundary.size();
  const Attempt closed =
      ChartFlattener(chart, {}, kSeparated).attempt(BoundaryBounds(n, 2), nullptr);
  REQUIRE(closed.validity.crossings.count > 0);
  // The layout's present angles, except where it is free anyway.
  BoundaryBounds present;
  for (const ChartCorner h : chart.boundary)
    present.push_back(boundaryAngle(chart, closed.uv, h) / kPi);
  ChartFlattener flattener(chart, {}, {true, present, {}});
  const Attempt open = movedApart(flattener, closed);
  CHECK_FALSE(open.valid());
  CHECK(open.validity.valid());
  CHECK(open.exceeded.count > 0);
}

TEST_CASE("straight runs that touch are drawn back as a whole") {
  for (const unsigned n : {6u, 20u}) {
    const DiskChart chart = chartOf(slitSheet(n, 0));
    StraightPlaces straight(chart.boundary.size(), 0);
    // Both sides of the slit.
    for (const BoundaryIndex i : straight.ids()) {
      const double* p = &chart.positions[3 * std::size_t{chart.boundaryVertex(i)}];
      straight[i] = p[0] * chart.unit == n / 2 && p[1] > 0 && p[1] * chart.unit < n / 2;
    }
    REQUIRE(placesThatTurn(chart, straight) + 2 * (n / 2 - 1) == chart.boundary.size());
    ChartFlattener flattener(chart, {}, {true, {}, straight});
    const Attempt closed = flattener.attempt(BoundaryBounds(chart.boundary.size(), 2), nullptr);
    REQUIRE(closed.validity.crossings.count > 0);
    const Attempt open = movedApart(flattener, closed);
    CHECK(open.valid());
    CHECK(open.bent.count == 0);
    CHECK(open.straight->deviation < 1e-6);
    CHECK(areaUv(chart, open.uv) == Approx(surfaceArea(chart)).epsilon(1e-12));
  }
}

TEST_CASE("charts that touch themselves cost no more than one solution each") {
  PolygonMesh mesh = uvSphere(200, 100);
  // Slits at the poles that are too wide to be closed.
  for (std::size_t v = 0; v < mesh.vertexCount(); ++v)
    if (std::abs(mesh.positions[3 * v]) < 1e-9)
      mesh.positions[3 * v] += 1e-8 * static_cast<double>(v % 3);
  const Counted sphere = unwrapped(mesh);
  CHECK(sphere.report.valid);
  // It takes three steps. Untangling took hundreds, with dozens of calls each.
  CHECK(sphere.steps <= 200);
  CHECK(sphere.report.symmetricDirichlet < 1.04);
  CHECK(sphere.report.seams.relativeLength < 1.4);
}

TEST_CASE("poles do not touch themselves") {
  const Counted sphere = unwrapped(uvSphere(cases(200, 80), cases(100, 40)));
  CHECK(sphere.report.valid);
  REQUIRE(sphere.report.charts.size() == 1);
  CHECK(sphere.report.charts[0].fallbacks.empty());
  CHECK(sphere.report.symmetricDirichlet < 1.04);
  CHECK(sphere.report.seams.relativeLength < 1.45);
}

TEST_CASE("what is stretched too much is cut before it is untangled", "[quality]") {
  const Counted towers = unwrapped(city(28, 6));
  CHECK(towers.report.valid);
  // The plane with all towers is a single chart at first. It crosses itself at thousands of places,
  // which took hundreds of steps.
  CHECK(towers.firstSteps <= 100);
  const int charts = static_cast<int>(towers.report.charts.size());
  CHECK(towers.steps <= 8 * charts);
  int newtonSteps = 0;
  for (const UnwrapChart& chart : towers.report.charts) {
    CHECK((chart.solver == Solver::ActiveSet || chart.solver == Solver::Projection));
    newtonSteps += chart.iterations;
  }
  CHECK(newtonSteps <= 4 * charts);
}
