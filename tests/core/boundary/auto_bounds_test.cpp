#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "abflat/flatten.h"
#include "abflat/samples.h"
#include "base/constants.h"
#include "boundary/chart_flattener.h"
#include "catch.h"
#include "flatten/chart_report.h"
#include "support/meshes.h"
#include "support/problems.h"
#include "support/squares.h"

using namespace abflat;
using namespace abflat::test;

namespace {

PolygonMesh sample(const std::string& name) {
  for (const Sample& s : samples())
    if (s.name == name) return s.make(1);
  throw std::runtime_error(name);
}

ChartReport flattened(const PolygonMesh& mesh, double t, Untangle untangle = Untangle::Auto,
                      std::vector<VertexBound> bounds = {}) {
  FlattenOptions options;
  options.t = t;
  options.untangle = untangle;
  options.bounds = std::move(bounds);
  const Result<FlattenResult> r = flatten(mesh, options);
  INFO(r.status().message);
  REQUIRE(r.ok());
  return r.value().report.charts.front();
}

}  // namespace

TEST_CASE("auto leaves a boundary free that does not cross itself") {
  const PolygonMesh mesh = bumpyGrid(8, 8, 0.3, 1);
  const ChartReport automatic = flattened(mesh, kAutoT), free = flattened(mesh, 2);
  CHECK(automatic.valid);
  CHECK(automatic.angularDistortion == free.angularDistortion);
  CHECK(automatic.t == 2);
  CHECK(automatic.bounds.empty());
}

TEST_CASE("every way of untangling gives a valid layout between free and convex") {
  const PolygonMesh mesh = sample("alpha-band");
  const ChartReport free = flattened(mesh, 2), convex = flattened(mesh, 1);
  REQUIRE(free.boundaryCrossings > 0);
  CHECK(free.problem.find("crosses itself") != std::string::npos);
  REQUIRE(convex.valid);
  for (const Untangle u : {Untangle::Auto, Untangle::Local, Untangle::Global, Untangle::Best}) {
    const ChartReport r = flattened(mesh, kAutoT, u);
    CHECK(r.valid);
    CHECK(r.angularDistortion >= free.angularDistortion);
    CHECK(r.angularDistortion <= convex.angularDistortion * (1 + 1e-9));
  }
  CHECK(flattened(mesh, 2, Untangle::Local).valid);
  CHECK_FALSE(flattened(mesh, 2, Untangle::None).valid);
}

TEST_CASE("the global search returns the largest t in hundredths without a crossing") {
  const PolygonMesh mesh = sample("alpha-band");
  const ChartReport r = flattened(mesh, kAutoT, Untangle::Global);
  REQUIRE(r.valid);
  CHECK(r.t * 100 == Approx(std::round(r.t * 100)));
  CHECK(flattened(mesh, r.t).valid);
  CHECK_FALSE(flattened(mesh, r.t + 0.01).valid);
}

TEST_CASE("auto unfolds boundaries that cross when they are free") {
  for (const char* file : {"camel-cut.obj", "cow-cut.off"}) {
    const PolygonMesh mesh = sharedMesh(file);
    if (mesh.faceCount() == 0) return;
    const ChartReport r = flattened(mesh, kAutoT);
    CHECK(r.valid);
    CHECK(r.boundaryCrossings == 0);
    CHECK(r.angularDistortion <= (std::string(file) == "camel-cut.obj" ? 0.00757 : 0.0064));
  }
}

TEST_CASE("bounds of single vertices are kept, the others keep the common one") {
  const PolygonMesh mesh = bumpyGrid(6, 6, 0.3, 2);
  const DiskChart chart = chartOf(mesh);
  const BoundaryIndex place(7);
  const std::uint32_t vertex = chart.inputVertex[chart.boundaryVertex(place)];
  const ChartReport free = flattened(mesh, 2);
  const ChartReport r = flattened(mesh, 2, Untangle::Auto, {{vertex, 0.7}});
  REQUIRE(r.valid);
  REQUIRE(r.bounds.size() == 1);
  CHECK(r.bounds[0].vertex == vertex);
  CHECK(r.angularDistortion > free.angularDistortion);

  ChartFlattener flattener(chart, {});
  BoundaryBounds t(chart.boundary.size(), 2);
  t[place] = 0.7;
  const Attempt a = flattener.attempt(t, nullptr);
  double angle = 0;
  for (const ChartCorner c : chart.corners())
    if (chart.vertexOfCorner[c] == chart.boundaryVertex(place)) angle += a.solution.angles[c];
  CHECK(angle == Approx(0.7 * kPi));
}

TEST_CASE("bounds asked for are upper limits, however crossings are removed") {
  const PolygonMesh mesh = sample("alpha-band");
  const DiskChart chart = chartOf(mesh);
  const auto n = static_cast<std::uint32_t>(chart.boundary.size());
  std::mt19937 random(3);
  for (const double t : {kAutoT, 2.0, 1.7})
    for (const Untangle u :
         {Untangle::None, Untangle::Local, Untangle::Global, Untangle::Best, Untangle::Auto}) {
      FlattenOptions options;
      options.t = t;
      options.untangle = u;
      BoundaryBounds asked(n, t == kAutoT ? 2 : t);
      for (int i = 0; i < 5; ++i) {
        const BoundaryIndex place(static_cast<std::uint32_t>(random()) % n);
        asked[place] = 0.6 + 0.1 * static_cast<double>(random() % 10);
        options.bounds.push_back({chart.inputVertex[chart.boundaryVertex(place)], asked[place]});
      }
      const Result<FlattenResult> r = flatten(mesh, options);
      INFO(r.status().message);
      REQUIRE(r.ok());
      const ChartReport& report = r.value().report.charts.front();
      INFO("t " << t << ", untangle " << nameOf(u) << ", " << report.problem);
      const bool isKept = exceededBounds(chart, r.value().uv, asked).count == 0;
      if (report.solver == Solver::Tutte)
        CHECK(report.valid == isKept);
      else
        CHECK(isKept);
      for (const VertexBound& b : options.bounds) {
        if (b.t >= report.t) continue;
        const auto of = [&](const VertexBound& x) { return x.vertex == b.vertex; };
        const auto found = std::find_if(report.bounds.begin(), report.bounds.end(), of);
        REQUIRE(found != report.bounds.end());
      }
    }
}

TEST_CASE("Tutte's embedding is not valid where it exceeds a bound, and says so") {
  const DiskChart chart = chartOf(bumpyGrid(8, 8, 0.3, 1));
  BoundaryBounds t(chart.boundary.size(), 2);
  const auto tutte = [&] {
    ChartFlattener flattener(chart, {}, {false, t, {}});
    return flattener.tutte(t, "asked for");
  };
  const Attempt free = tutte();
  CHECK(free.exceeded.count == 0);
  t[BoundaryIndex(3)] = t[BoundaryIndex(9)] = 0.5;
  t[BoundaryIndex(12)] = 1.2;
  const Attempt a = tutte();
  CHECK(a.exceeded.count == 2);
  CHECK(a.exceeded.most ==
        Approx(kPi * (1 - 2.0 / static_cast<double>(t.size()) - 0.5)).margin(0.1));
  CHECK_FALSE(a.valid());
  CHECK(a.t[BoundaryIndex(3)] == 0.5);
  const ChartReport report = makeChartReport(chart, a, 1);
  CHECK_FALSE(report.valid);
  CHECK(report.problem.find("exceeds 2 of the requested bounds") != std::string::npos);
  CHECK(report.bounds.size() == 2);
}

TEST_CASE("bounds that cannot be are refused") {
  const PolygonMesh mesh = bumpyGrid(3, 3, 0.3, 2);
  FlattenOptions options;
  options.t = 1;
  options.bounds = {{5, 1.0}};  // an interior vertex
  CHECK(flatten(mesh, options).status().code == StatusCode::InvalidOption);
  options.bounds = {{0, -1.0}};
  CHECK(flatten(mesh, options).status().code == StatusCode::InvalidOption);
  options.bounds.clear();
  for (std::uint32_t v = 0; v < 4; ++v) options.bounds.push_back({v, 0.1});
  CHECK(flatten(mesh, options).status().code == StatusCode::InfeasibleBound);
}

TEST_CASE("a warm start reaches the same layout as a cold one") {
  const DiskChart chart = chartOf(bumpyGrid(10, 10, 0.4, 3));
  ChartFlattener flattener(chart, {});
  const std::size_t n = chart.boundary.size();
  const Attempt free = flattener.attempt(BoundaryBounds(n, 2), nullptr);
  const Attempt cold = flattener.attempt(BoundaryBounds(n, 1), nullptr);
  const Attempt warm = flattener.attempt(BoundaryBounds(n, 1), &free);
  CHECK(warm.solution.history.size() <= cold.solution.history.size());
  for (std::size_t i = 0; i < cold.uv.size(); ++i)
    CHECK(warm.uv[i] == Approx(cold.uv[i]).margin(1e-6));
}

TEST_CASE("Tutte's embedding is valid and labelled") {
  for (const PolygonMesh& mesh : {bumpyGrid(8, 8, 0.3, 1), cone(9, 1), sample("head")}) {
    const DiskChart chart = chartOf(mesh);
    const Attempt a =
        ChartFlattener(chart, {}).tutte(BoundaryBounds(chart.boundary.size(), 2), "asked for");
    CHECK(a.valid());
    CHECK(a.solver == Solver::Tutte);
    CHECK(a.fallbacks.size() == 1);
    CHECK(a.validity.maxBoundaryAngle < kPi);
  }
}

TEST_CASE("tiny edges of the boundary are apart, parts of it that nearly touch are not") {
  const auto planar = [](const PolygonMesh& mesh, auto place) {
    std::vector<double> uv;
    for (std::size_t v = 0; v < mesh.vertexCount(); ++v)
      for (const double x : place(mesh.positions[3 * v], mesh.positions[3 * v + 1]))
        uv.push_back(x);
    return uv;
  };
  using Place = std::array<double, 2>;
  constexpr double kTiny = 1e-9;
  const PolygonMesh sheet = squares(6, 4, [](auto, auto) { return true; });
  const std::vector<double> uv = planar(sheet, [&](double x, double y) {
    return Place{y == 0 && x == 3 ? 2 + kTiny : x, x == 6 && y == 1 ? kTiny : y};
  });
  CHECK(checkSeparated(chartOf(sheet), uv).valid());
  const PolygonMesh legs = squares(3, 3, [](auto i, auto j) { return i != 1 || j == 0; });
  const DiskChart chart = chartOf(legs);
  for (const double gap : {0.1, kTiny}) {
    const std::vector<double> bent = planar(legs, [&](double x, double y) {
      return Place{x >= 2 ? x - 1 + gap : x, y};
    });
    CHECK(checkValidity(chart, bent).valid());
    CHECK(checkSeparated(chart, bent).valid() == (gap > kTiny));
  }
}
