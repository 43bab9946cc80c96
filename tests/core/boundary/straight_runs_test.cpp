#include "boundary/straight_runs.h"

#include <algorithm>
#include <cmath>

#include "abflat/unwrap.h"
#include "base/constants.h"
#include "catch.h"
#include "check/validity.h"
#include "mesh/surface.h"
#include "solve/angle_solver.h"
#include "support/meshes.h"

using namespace abflat;
using namespace abflat::test;

namespace {

/// A bumpy grid, with its four sides as runs, counter-clockwise.
struct Sheet {
  PolygonMesh mesh = bumpyGrid(8, 6, 0.5, 11);
  std::vector<StraightRun> sides = {{0, 8}, {8, 62}, {62, 54}, {54, 0}};

  DiskChart chart() const { return makeDiskChart(mesh, buildSurface(mesh)); }
};

Result<FlattenResult> flattened(const PolygonMesh& mesh, const std::vector<StraightRun>& straight,
                                double t, const std::vector<VertexBound>& bounds = {}) {
  FlattenOptions options;
  options.t = t;
  options.straight = straight;
  options.bounds = bounds;
  return flatten(mesh, options);
}

/// Largest distance of the vertices from the line through two of them, divided by its length.
double offLine(const FlattenResult& r, const std::vector<std::uint32_t>& vertices) {
  const auto at = [&](std::uint32_t v, std::size_t d) { return r.uv[2 * std::size_t{v} + d]; };
  const std::uint32_t a = vertices.front(), b = vertices.back();
  const double x = at(b, 0) - at(a, 0), y = at(b, 1) - at(a, 1);
  double worst = 0;
  for (const std::uint32_t v : vertices)
    worst = std::max(worst, std::abs(x * (at(v, 1) - at(a, 1)) - y * (at(v, 0) - at(a, 0))));
  return worst / (x * x + y * y);
}

}  // namespace

TEST_CASE("straight runs are lines of the layout, for every t", "[straight]") {
  const Sheet sheet;
  for (const double t : {kAutoT, 1.0, 2.0}) {
    const Result<FlattenResult> r = flattened(sheet.mesh, sheet.sides, t);
    INFO(r.status().message);
    REQUIRE(r.ok());
    CHECK(r.value().report.valid);
    const ChartReport& chart = r.value().report.charts[0];
    CHECK(chart.constraintResidual < 1e-9);
    REQUIRE(chart.straight);
    CHECK(chart.straight->runs == 4);
    CHECK(chart.straight->vertices == 24);
    CHECK(chart.straight->released == 0);
    CHECK(chart.straight->deviation < 1e-8);
    CHECK(chart.bounds.empty());
    CHECK(offLine(r.value(), {0, 1, 2, 3, 4, 5, 6, 7, 8}) < 1e-9);
    CHECK(offLine(r.value(), {8, 17, 26, 35, 44, 53, 62}) < 1e-9);
    CHECK(offLine(r.value(), {54, 55, 58, 61, 62}) < 1e-9);
  }
  const Result<FlattenResult> free = flattened(sheet.mesh, {}, 2);
  REQUIRE(free.ok());
  CHECK_FALSE(free.value().report.charts[0].straight);
  CHECK(offLine(free.value(), {0, 1, 2, 3, 4, 5, 6, 7, 8}) > 1e-3);
}

TEST_CASE("the interior point holds straight vertices, too", "[straight]") {
  const Sheet sheet;
  const DiskChart chart = sheet.chart();
  AngleProblem problem = buildAngleProblem(chart);
  const Result<StraightPlaces> straight = straightPlaces(chart, sheet.sides);
  REQUIRE(straight.ok());
  setBounds(problem, chart, BoundaryBounds(chart.boundary.size(), 0.9));
  setStraight(problem, chart, straight.value());
  AngleSolver solver(problem, {});
  const AngleSolution exact = solver.solve(nullptr), s = solver.solveWithFloor(1e-9);
  REQUIRE(exact.converged);
  REQUIRE(s.converged);
  CHECK(s.barrierFloor > 0);
  IdVector<ChartVertex, double> sum(chart.vertexCount(), 0);
  for (const ChartCorner c : chart.corners()) sum[chart.vertexOfCorner[c]] += s.angles[c];
  for (const BoundaryIndex i : chart.boundary.ids()) {
    const double angle = sum[chart.boundaryVertex(i)];
    if (straight.value()[i] != 0)
      CHECK(std::abs(angle - kPi) < 1e-9);
    else
      CHECK(angle < 0.9 * kPi + 1e-9);
  }
  for (std::size_t c = 0; c < s.angles.size(); ++c)
    CHECK(std::abs(s.angles[c] - exact.angles[c]) < 1e-4);
}

TEST_CASE("how straight runs are is measured again once a layout is rounded", "[straight]") {
  const Sheet sheet;
  const DiskChart chart = sheet.chart();
  const Result<StraightPlaces> places = straightPlaces(chart, sheet.sides);
  REQUIRE(places.ok());
  for (const bool isGltf : {false, true}) {
    Result<FlattenResult> r = flattened(sheet.mesh, sheet.sides, kAutoT);
    REQUIRE(r.ok());
    CHECK(r.value().straight == straightVertices(chart, places.value()));
    const double before = r.value().report.charts[0].straight->deviation;
    if (isGltf)
      roundForGltf(sheet.mesh, r.value());
    else
      REQUIRE(roundToSinglePrecision(sheet.mesh, r.value()));
    const double now = r.value().report.charts[0].straight->deviation;
    CHECK(now ==
          Approx(reportStraight(chart, places.value(), r.value().uv).deviation).epsilon(1e-6));
    CHECK(now > 2 * before);
    CHECK(now < 1e-4);
  }
}

TEST_CASE("straight runs of an atlas are measured as they are written", "[straight]") {
  const Sheet sheet;
  UnwrapOptions options;
  options.straightSeams = true;
  const auto deviation = [&](bool isSingle) {
    options.precision = isSingle ? Precision::Single : Precision::Double;
    const Result<UnwrapResult> r = unwrap(sheet.mesh, options);
    REQUIRE(r.ok());
    REQUIRE(r.value().report.charts.at(0).straight);
    return r.value().report.charts[0].straight->deviation;
  };
  CHECK(deviation(true) > 100 * deviation(false));
}

TEST_CASE("straight runs that no layout can have are named", "[straight]") {
  const Sheet sheet;
  const auto message = [&](const std::vector<StraightRun>& runs, StatusCode code) {
    const Result<FlattenResult> r = flattened(sheet.mesh, runs, 2);
    CHECK(r.status().code == code);
    return r.status().message;
  };
  using Catch::Contains;
  CHECK_THAT(message({{0, 8}, {8, 7}}, StatusCode::InfeasibleBound), Contains("fewer than three"));
  CHECK_THAT(message({{0, 30}}, StatusCode::InvalidOption),
             Contains("vertex 30") && Contains("not on the boundary"));
  CHECK_THAT(message({{3, 3}}, StatusCode::InvalidOption), Contains("begins and ends at vertex 3"));
  // One of the two other corners has a single triangle.
  const std::string a = flattened(sheet.mesh, {{7, 17}}, 2).status().message;
  const std::string b = flattened(sheet.mesh, {{1, 9}, {9, 1}}, 2).status().message;
  CHECK((a + b).find("cuts off part of a straight run") != std::string::npos);
}

TEST_CASE("a tube cut open with straight seams is a rectangle", "[straight]") {
  const PolygonMesh mesh = cylinder(16, 6);
  UnwrapOptions options;
  options.straightSeams = true;
  options.seams.isAuto = false;
  for (std::uint32_t j = 0; j < 6; ++j) options.seams.edges.push_back({16 * j, 16 * (j + 1)});
  const Result<UnwrapResult> result = unwrap(mesh, options);
  INFO(result.status().message);
  REQUIRE(result.ok());
  const UnwrapReport& report = result.value().report;
  CHECK(report.valid);
  REQUIRE(report.charts.size() == 1);
  REQUIRE(report.charts[0].straight);
  CHECK(report.charts[0].straight->runs == 4);
  CHECK(report.charts[0].straight->released == 0);
  CHECK(report.charts[0].straight->vertices == 2 * 15 + 2 * 5);
  CHECK(report.charts[0].straight->deviation < 1e-8);
}

TEST_CASE("round rims are not made straight, and the report says so", "[straight]") {
  const PolygonMesh mesh = cone(24, 0.3);
  UnwrapOptions options;
  options.straightSeams = true;
  options.seams.isAuto = false;
  const Result<UnwrapResult> result = unwrap(mesh, options);
  REQUIRE(result.ok());
  CHECK(result.value().report.valid);
  REQUIRE(result.value().report.charts[0].straight);
  CHECK(result.value().report.charts[0].straight->vertices == 0);
  CHECK(result.value().report.charts[0].straight->released == 24);
}

TEST_CASE("bounds and runs that single precision cannot hold stay in double precision") {
  // Steps of a millionth of the sheet along one side, which go up and down.
  PolygonMesh mesh = bumpyGrid(40, 4, 0, 1);
  for (std::size_t v = 0; v < mesh.vertexCount(); ++v)
    if (v % 41 > 1) mesh.positions[3 * v] = 1e6 + mesh.positions[3 * v];
  for (const bool isStraight : {false, true}) {
    FlattenOptions options;
    options.t = isStraight ? kAutoT : 1;
    if (isStraight) options.straight = {{0, 40}, {40, 204}, {204, 164}, {164, 0}};
    Result<FlattenResult> r = flatten(mesh, options);
    INFO(r.status().message);
    REQUIRE(r.ok());
    REQUIRE(r.value().report.valid);
    const std::vector<double> before = r.value().uv;
    CHECK_FALSE(roundToSinglePrecision(mesh, r.value()));
    CHECK(r.value().uv == before);
    CHECK(r.value().report.valid);
    CHECK_FALSE(r.value().report.charts[0].fallbacks.empty());
    roundForGltf(mesh, r.value());
    CHECK_FALSE(r.value().report.valid);
    CHECK_FALSE(r.value().report.charts[0].problem.empty());
  }
}
