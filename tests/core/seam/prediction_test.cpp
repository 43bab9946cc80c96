#include "seam/prediction.h"

#include <cmath>

#include "abflat/samples.h"
#include "catch.h"
#include "seam/chords.h"
#include "seam/log_scale.h"
#include "seam/outline.h"
#include "support/cut_meshes.h"
#include "support/meshes.h"
#include "support/squares.h"

using namespace abflat;
using namespace abflat::test;

namespace {

PolygonMesh sample(std::string_view name) {
  for (const Sample& s : samples())
    if (s.name == name) return s.make(4);
  FAIL("no such sample");
  return {};
}

CutSurface uncut(const Cuttable& c) { return cutAlong(c.seamMesh, Seams(c.seamMesh.twin.size())); }

}  // namespace

TEST_CASE("the log-scale of a half sphere is that of stereographic projection", "[seams]") {
  const Cuttable c(sample("hemisphere"));
  const CutSurface s = uncut(c);
  REQUIRE(s.charts.size() == 1);
  const LogScales u = LogScale(c.seamMesh, nullptr).solve(s, {});
  double least = 0, top = -1e9;
  for (const double x : u) {
    least = std::min(least, x);
    top = std::max(top, x);
  }
  CHECK(top < 1e-6);
  CHECK(least == Approx(std::log(0.5)).epsilon(0.02));
  // e^(2u) is 1 / (1 + z)^2 and z is uniform over the area, so its mean is 1/2, and that of its
  // inverse 7/3.
  CHECK(predictStretch(c.seamMesh, s, u).stretch.front() ==
        Approx((1 + 0.5 * 7.0 / 3) / 2).epsilon(0.01));
}

TEST_CASE("stretch counts less where there is leeway", "[seams]") {
  const Cuttable c(sample("hemisphere"));
  const CutSurface s = uncut(c);
  const LogScales u = LogScale(c.seamMesh, nullptr).solve(s, {});
  const Prediction plain = predictStretch(c.seamMesh, s, u);
  SeamMesh half = c.seamMesh;
  half.front.assign(half.triangleCount(), 0.5);
  half.frontLeeway = 9;
  const Prediction told = predictStretch(half, s, u);
  CHECK(told.leeway.front() == Approx(5));
  CHECK(5 * (told.stretch.front() - 1) == Approx(plain.stretch.front() - 1));
  CHECK(told.total == Approx(plain.total));
}

TEST_CASE("a flat chart keeps its scale and its outline", "[seams]") {
  const Cuttable c(squares(9, 4, [](std::uint32_t i, std::uint32_t j) { return i < 3 || j < 2; }));
  const CutSurface s = uncut(c);
  const LogScales u = LogScale(c.seamMesh, nullptr).solve(s, {});
  for (const double x : u) CHECK(std::abs(x) < 1e-6);
  const Outline outline = predictOutline(c.seamMesh, s, CutChartId(0), u);
  CHECK(polygonArea(outline) == Approx(c.seamMesh.totalArea()).epsilon(1e-5));
  const Shape shape = measureShape(outline);
  CHECK(shape.overlap == 0);
  CHECK(shape.fill == Approx(24.0 / (12 + 12 + 6)).epsilon(1e-4));
}

TEST_CASE("a cut cylinder is predicted to become a rectangle", "[seams]") {
  const Cuttable c(cylinder(48, 10));
  Seams seams = findSeams(c.seamMesh, {}, {}, nullptr);
  const CutSurface s = cutAlong(c.seamMesh, seams);
  const LogScales u = LogScale(c.seamMesh, nullptr).solve(s, {});
  const Shape shape = measureShape(predictOutline(c.seamMesh, s, CutChartId(0), u));
  CHECK(shape.fill == Approx(1).margin(1e-4));
  CHECK(shape.overlap == 0);
  CHECK(predictStretch(c.seamMesh, s, u).total == Approx(1).margin(1e-6));
}

TEST_CASE("what a ring covers twice is measured, and found to cross", "[seams]") {
  Outline ring;  // 450 degrees between the radii 1 and 2
  for (int i = 0; i <= 450; i += 2)
    ring.push_back({2 * std::cos(i * 0.0174532925), 2 * std::sin(i * 0.0174532925)});
  for (int i = 450; i >= 0; i -= 2)
    ring.push_back({std::cos(i * 0.0174532925), std::sin(i * 0.0174532925)});
  for (Point2& p : ring) p = {p[0] + 0.001 * p[1], p[1] - 0.013 * p[0]};  // no edges coincide
  const Shape shape = measureShape(ring);
  CHECK(shape.overlap == Approx(0.2).epsilon(0.05));
  CHECK(!shape.crossings.empty());
}

TEST_CASE("the shortest chord of a dumb-bell is across its handle", "[seams]") {
  const Cuttable c(squares(30, 10,
                           [](std::uint32_t i, std::uint32_t j) {
                             return i < 10 || i >= 20 || (j >= 4 && j < 6);
                           }),
                   SeamCosts::Length);
  const CutSurface s = uncut(c);
  const PathForest forest = findPaths(c.seamMesh, s, {});
  const CutPaths paths{c.seamMesh, s, forest};
  const Chord chord = ChordFinder(paths).best(CutChartId(0), {});
  REQUIRE(chord.h.exists());
  const double side = std::sqrt(c.seamMesh.totalArea() / (2 * 10 * 10 + 10 * 2));
  CHECK(chord.length == Approx(2 * side).epsilon(1e-6));
  CHECK(std::min(chord.left, chord.right) >= 0.4 * c.seamMesh.totalArea());
  Seams seams(c.seamMesh.twin.size(), 0);
  markThrough(paths, chord.h, seams);
  const CutSurface cut = cutAlong(c.seamMesh, seams);
  REQUIRE(cut.charts.size() == 2);
  CHECK(std::min(cut.charts.front().area, cut.charts.back().area) ==
        Approx(std::min(chord.left, chord.right)));
  for (const CutSurface::Chart& chart : cut.charts) CHECK(chart.isDisk());
}
