#include <algorithm>
#include <cmath>
#include <limits>

#include "base/constants.h"
#include "base/point2.h"
#include "boundary/chart_flattener.h"
#include "catch.h"
#include "flatten/level_runs.h"
#include "flatten/rectify_chart.h"
#include "refine/level_springs.h"
#include "support/meshes.h"
#include "support/problems.h"
#include "support/squares.h"

using namespace abflat;
using namespace abflat::test;

namespace {

constexpr unsigned kColumns = 24, kRows = 6;

/// A flat chart of a grid, and the layout that a map of the plane gives it.
struct Bent {
  DiskChart chart;
  std::vector<double> uv;
};

template <class Map>
Bent bent(const PolygonMesh& mesh, const Map& map) {
  Bent out{chartOf(mesh), {}};
  const std::vector<double> p = out.chart.positions;
  for (std::size_t i = 0; i < p.size(); i += 3) {
    const Point2 q = map(p[i] * out.chart.unit, p[i + 1] * out.chart.unit);
    out.uv.insert(out.uv.end(), {q[0], q[1]});
  }
  return out;
}

PolygonMesh strip(std::uint32_t columns = kColumns) {
  return squares(columns, kRows, [](auto...) { return true; });
}

/// A strip that is bent by the given angle, and turned.
Bent arc(double angle, double turn = 0.3) {
  return bent(strip(), [&](double x, double y) {
    const double radius = kColumns / angle;
    const double a = turn + x / radius;
    return Point2{(radius - y) * std::sin(a), -(radius - y) * std::cos(a)};
  });
}

RectifyOptions usual() {
  RectifyOptions out;
  out.balance = 0.2;
  out.allowedBytes = std::numeric_limits<std::uint64_t>::max();
  return out;
}

std::size_t countOf(const DiskChart& chart, const LevelRun& run) {
  std::size_t out = 0;
  for (BoundaryIndex i = run.from; i != run.to; i = chart.after(i)) ++out;
  return out;
}

}  // namespace

TEST_CASE("a bent strip is seen as a rectangle", "[rectify]") {
  const Bent bow = arc(0.6);
  const LevelRuns found = findLevelRuns(bow.chart, bow.uv);
  REQUIRE(found.runs.size() == 4);
  std::vector<std::size_t> counts;
  for (const LevelRun& run : found.runs) counts.push_back(countOf(bow.chart, run));
  std::sort(counts.begin(), counts.end());
  CHECK(counts == std::vector<std::size_t>{kRows, kRows, kColumns, kColumns});
  CHECK(found.share == Approx(1));
  CHECK(found.before < 0.5);
}

TEST_CASE("sides that deviate too much are left out", "[rectify]") {
  const Bent bow = arc(0.6);
  const LevelRuns found = findLevelRuns(bow.chart, bow.uv, {0.4, 0.02});
  CHECK(found.runs.size() < 4);
  CHECK(found.share < 0.5);
  CHECK(findLevelRuns(bow.chart, bow.uv, {0.999, 0.349}).runs.empty());
}

TEST_CASE("a bent L has six sides", "[rectify]") {
  const PolygonMesh ell =
      squares(12, 12, [](std::uint32_t i, std::uint32_t j) { return i < 4 || j < 5; });
  const Bent one = bent(ell, [](double x, double y) {
    return Point2{x + 0.015 * y * y, y - 0.02 * x * x};
  });
  const LevelRuns found = findLevelRuns(one.chart, one.uv);
  CHECK(found.runs.size() == 6);
  CHECK(!rectified(one.chart, one.uv, usual()).uv.empty());
}

TEST_CASE("a round outline has no level runs", "[rectify]") {
  const DiskChart disc = chartOf(cone(40, 0));
  std::vector<double> uv;
  for (std::size_t i = 0; i < disc.positions.size(); i += 3)
    uv.insert(uv.end(), {disc.positions[i], disc.positions[i + 1]});
  CHECK(findLevelRuns(disc, uv).runs.empty());
  CHECK(rectified(disc, uv, usual()).uv.empty());
}

TEST_CASE("a strip bent too far stays as it is", "[rectify]") {
  const Bent bow = arc(2.5);
  const Rectified out = rectified(bow.chart, bow.uv, usual());
  CHECK(out.uv.empty());
}

TEST_CASE("a rectangle that is one already stays as it is", "[rectify]") {
  const double turn = 0.7;
  const Bent one = bent(strip(), [&](double x, double y) {
    return Point2{x * std::cos(turn) - y * std::sin(turn), x * std::sin(turn) + y * std::cos(turn)};
  });
  const LevelRuns found = findLevelRuns(one.chart, one.uv);
  CHECK(found.before == Approx(found.share));
  CHECK(rectified(one.chart, one.uv, usual()).uv.empty());
}

TEST_CASE("a bent strip becomes a rectangle, exactly", "[rectify]") {
  const Bent bow = arc(0.6);
  const Rectified out = rectified(bow.chart, bow.uv, usual());
  REQUIRE(!out.uv.empty());
  CHECK(out.gain > 0.5);
  CHECK(checkSeparated(bow.chart, out.uv).valid());
  // The surface is flat, so nothing is left of what bending it had stretched.
  CHECK(measureDistortion(bow.chart, out.uv).symmetricDirichlet < 1 + 1e-3);
  double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
  for (std::size_t i = 0; i < out.uv.size(); ++i) {
    low[i % 2] = std::min(low[i % 2], out.uv[i]);
    high[i % 2] = std::max(high[i % 2], out.uv[i]);
  }
  for (const ChartCorner h : bow.chart.boundary) {
    const ChartVertex v = bow.chart.vertexOfCorner[h];
    bool isOnBox = false;
    for (std::size_t d = 0; d < 2; ++d)
      for (const double side : {low[d], high[d]}) isOnBox = isOnBox || out.uv[2 * v + d] == side;
    CHECK(isOnBox);
  }
}

TEST_CASE("however a layout is turned, the rectangle is the same", "[rectify]") {
  const Bent one = arc(0.5, 0.1), other = arc(0.5, 2.2);
  const Rectified a = rectified(one.chart, one.uv, usual());
  const Rectified b = rectified(other.chart, other.uv, usual());
  REQUIRE(!a.uv.empty());
  REQUIRE(!b.uv.empty());
  const double stretch = measureDistortion(one.chart, a.uv).symmetricDirichlet;
  CHECK(measureDistortion(other.chart, b.uv).symmetricDirichlet == Approx(stretch).epsilon(1e-6));
}

TEST_CASE("the energy of level springs changes as differences say", "[rectify]") {
  const Bent bow = arc(0.6);
  LevelEdges level;
  level.stiffness = 3;
  for (const BoundaryIndex i : bow.chart.boundary.ids())
    level.edges.push_back(
        {bow.chart.boundaryVertex(i), bow.chart.boundaryVertex(bow.chart.after(i)),
         static_cast<std::uint8_t>(i % 2), 0.5 + 0.1 * static_cast<double>(i % 3)});
  const LevelSprings springs(level);
  std::vector<double> uv = bow.uv;
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(uv.size()));
  SparseEntries hessian;
  springs.addDerivatives(uv, gradient, hessian);
  Eigen::MatrixXd full = Eigen::MatrixXd::Zero(gradient.size(), gradient.size());
  for (const auto& e : hessian) {
    REQUIRE(e.row() >= e.col());
    full(e.row(), e.col()) += e.value();
    if (e.row() != e.col()) full(e.col(), e.row()) += e.value();
  }
  Eigen::VectorXd step(gradient.size());
  for (Eigen::Index i = 0; i < step.size(); ++i) step[i] = std::sin(static_cast<double>(7 * i));
  std::vector<double> next = uv;
  for (std::size_t i = 0; i < uv.size(); ++i) next[i] += step[static_cast<Eigen::Index>(i)];
  // The energy is quadratic, so this is exact.
  const double expected = gradient.dot(step) + 0.5 * step.dot(full * step);
  CHECK(springs.energy(next) - springs.energy(uv) == Approx(expected));
}
