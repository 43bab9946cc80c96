#include <algorithm>
#include <map>
#include <set>

#include "abflat/unwrap.h"
#include "catch.h"
#include "check/atlas_check.h"
#include "support/copies.h"
#include "support/squares.h"
#include "support/unwrapped.h"

using namespace abflat;
using namespace abflat::test;

namespace {

UnwrapOptions stacking(Stack stack) {
  UnwrapOptions out;
  out.resolution = 256;
  out.stack = stack;
  out.minUtilization = 0;  // charts are not cut for packing, which depends on how many there are
  return out;
}

using Place = std::array<double, 2>;

/// The places of a face's corners in the atlas.
std::multiset<Place> placesOf(const PolygonMesh& mesh, const UnwrapResult& result, std::size_t f) {
  std::multiset<Place> out;
  for (std::uint32_t c = mesh.faceOffsets[f]; c < mesh.faceOffsets[f + 1]; ++c) {
    const std::size_t i = 2 * std::size_t{result.cornerUv[c]};
    out.insert({result.uv[i], result.uv[i + 1]});
  }
  return out;
}

/// Whether each stacked chart has exactly the faces of the chart that it lies on, and nothing else
/// overlaps.
bool areStacksExact(const PolygonMesh& mesh, const UnwrapResult& result) {
  std::map<std::uint32_t, std::multiset<std::multiset<Place>>> faces;
  for (std::size_t f = 0; f < mesh.faceCount(); ++f)
    faces[result.chartOfFace[f]].insert(placesOf(mesh, result, f));
  std::vector<std::uint32_t> triangles;
  for (const std::uint32_t c : result.triangleCorners) triangles.push_back(result.cornerUv[c]);
  const std::vector<UnwrapChart>& charts = result.report.charts;
  WrittenAtlas lowest{result.uv,
                      triangles,
                      result.chartOfTriangle,
                      [](std::size_t) { return true; },
                      {},
                      std::vector<std::uint8_t>(charts.size(), 0)};
  for (std::uint32_t c = 0; c < charts.size(); ++c) {
    const int on = charts[c].stackedOn;
    lowest.isLeftOut.push_back(on >= 0);
    if (on >= 0 && (charts[on].stackedOn >= 0 || faces[c] != faces[on])) return false;
  }
  lowest.tiles = static_cast<std::uint32_t>(result.report.atlas.tiles);
  return checkAtlas(lowest).empty();
}

/// Sets of input faces that share their place, by the first of each, ignoring which lies on which.
std::size_t placesIn(const UnwrapResult& result) {
  const auto& charts = result.report.charts;
  return static_cast<std::size_t>(std::count_if(
      charts.begin(), charts.end(), [](const UnwrapChart& c) { return c.stackedOn < 0; }));
}

UnwrapResult stackedExactly(const PolygonMesh& mesh, const UnwrapOptions& options) {
  UnwrapResult out = unwrapped(mesh, options);
  CHECK(areStacksExact(mesh, out));
  const AtlasReport& atlas = out.report.atlas;
  CHECK(placesIn(out) + static_cast<std::size_t>(atlas.stackedCharts) == out.report.charts.size());
  return out;
}

}  // namespace

TEST_CASE("copies lie on each other, and take the room of one", "[stack]") {
  for (const PolygonMesh& part : {wedge(), torus(12, 8), bumpyGrid(7, 5, 0.5, 3)}) {
    const PolygonMesh mesh = copies(part, 8, 11);
    const UnwrapResult apart = unwrapped(mesh, stacking(Stack::None));
    CHECK(apart.report.atlas.stackedCharts == 0);
    const UnwrapResult on = stackedExactly(mesh, stacking(Stack::Identical));
    CHECK(8 * placesIn(on) <= on.report.charts.size());
    CHECK(on.report.atlas.stackedMirrored == 0);
    CHECK(on.report.atlas.texelDensity > 2 * apart.report.atlas.texelDensity);
    CHECK(on.report.seams.edges % 8 == 0);
  }
}

TEST_CASE("a stack of copies is laid out like one of them", "[stack]") {
  // With the others on top of it, the first copy is the model.
  PolygonMesh mesh = wedge();
  const UnwrapResult one = unwrapped(mesh, stacking(Stack::Identical));
  std::mt19937 random(1);
  for (int k = 0; k < 5; ++k) {
    Motion motion = randomMotion(random, false);
    for (double& x : motion.shift) x = 100 + 10 * k;
    append(mesh, moved(wedge(), motion, false));
  }
  const UnwrapResult all = stackedExactly(mesh, stacking(Stack::Identical));
  CHECK(all.report.charts.size() == 6 * one.report.charts.size());
  CHECK(all.report.atlas.texelDensity == Approx(one.report.atlas.texelDensity));
  CHECK(all.report.atlas.utilization == Approx(one.report.atlas.utilization));
}

TEST_CASE("mirror images lie on each other only if asked for, and run clockwise", "[stack]") {
  const PolygonMesh mesh = copies(wedge(), 6, 5, true);
  const UnwrapResult turned = stackedExactly(mesh, stacking(Stack::Identical));
  const UnwrapResult any = stackedExactly(mesh, stacking(Stack::Mirrored));
  CHECK(turned.report.atlas.stackedMirrored == 0);
  CHECK(any.report.atlas.stackedMirrored > 0);
  CHECK(placesIn(any) < placesIn(turned));
  for (const UnwrapChart& chart : any.report.charts)
    CHECK((!chart.mirrored || chart.stackedOn >= 0));
}

TEST_CASE("charts of one component lie on each other as well", "[stack]") {
  // The sides of a cube, each a chart.
  PolygonMesh cube;
  for (unsigned k = 0; k < 8; ++k)
    for (const unsigned bit : {1u, 2u, 4u}) cube.positions.push_back(k & bit ? 1 : 0);
  cube.faceVertices = {0, 4, 6, 2, 1, 3, 7, 5, 0, 1, 5, 4, 2, 6, 7, 3, 0, 2, 3, 1, 4, 5, 7, 6};
  cube.faceOffsets = {0, 4, 8, 12, 16, 20, 24};
  UnwrapOptions options = stacking(Stack::Identical);
  options.seams.isAuto = false;
  options.seams.sharpDegrees = 45;
  const UnwrapResult result = stackedExactly(cube, options);
  CHECK(result.report.charts.size() == 6);
  CHECK(result.report.atlas.stackedCharts == 5);
  CHECK(result.report.atlas.stackedPlaces == 1);
  CHECK(result.report.seams.edges == 12);
}

TEST_CASE("holes that are filled are filled in all copies", "[stack]") {
  // A wall with a window.
  PolygonMesh wall = bumpyGrid(9, 7, 0.05, 2);
  PolygonMesh open;
  open.positions = wall.positions;
  open.faceOffsets = {0};
  for (std::size_t f = 0; f < wall.faceCount(); ++f) {
    const std::size_t column = f / 2 % 9, row = f / 2 / 9;
    if (column == 4 && row == 3) continue;
    for (std::uint32_t c = wall.faceOffsets[f]; c < wall.faceOffsets[f + 1]; ++c)
      open.faceVertices.push_back(wall.faceVertices[c]);
    open.faceOffsets.push_back(static_cast<std::uint32_t>(open.faceVertices.size()));
  }
  for (const bool areMirrored : {false, true}) {
    const PolygonMesh mesh = copies(open, 4, 3, areMirrored);
    const UnwrapResult result =
        stackedExactly(mesh, stacking(areMirrored ? Stack::Mirrored : Stack::Identical));
    CHECK(result.report.seams.filledHoles == 4);
    CHECK(placesIn(result) == 1);
  }
}

TEST_CASE("faces of other density or material are not stacked", "[stack]") {
  PolygonMesh mesh = copies(wedge(), 4, 9);
  UnwrapOptions options = stacking(Stack::Identical);
  const std::size_t together = placesIn(stackedExactly(mesh, options));
  options.faceDensities.assign(mesh.faceCount(), 1);
  std::fill(options.faceDensities.begin() + 12, options.faceDensities.end(), 2.0);
  CHECK(placesIn(stackedExactly(mesh, options)) >= 2 * together);
  options.faceDensities.clear();
  mesh.faceMaterials.assign(mesh.faceCount(), 0);
  std::fill(mesh.faceMaterials.begin() + 12, mesh.faceMaterials.end(), 1);
  CHECK(placesIn(stackedExactly(mesh, options)) >= 2 * together);
}

TEST_CASE("given seams have to be the same", "[stack]") {
  PolygonMesh mesh;
  std::mt19937 random(1);
  append(mesh, wedge());
  append(mesh, moved(wedge(), randomMotion(random, false), false));
  UnwrapOptions options = stacking(Stack::Identical);
  options.seams.edges = {{0, 1}, {8, 9}};
  const UnwrapResult same = stackedExactly(mesh, options);
  CHECK(2 * placesIn(same) <= same.report.charts.size());
  options.seams.edges = {{0, 1}, {9, 10}};
  CHECK(placesIn(stackedExactly(mesh, options)) > placesIn(same));
}

TEST_CASE("pinned and fixed charts are left where they are", "[stack]") {
  const PolygonMesh mesh = copies(wedge(), 4, 6);
  UnwrapOptions options = stacking(Stack::Identical);
  const UnwrapResult first = stackedExactly(mesh, options);
  // All charts of the first component stay; the others are stacked beside them.
  options.reuse.known = knownLayout(first);
  std::set<std::uint32_t> fixed(first.chartOfFace.begin(), first.chartOfFace.begin() + 6);
  options.reuse.fixedCharts.assign(fixed.begin(), fixed.end());
  options.texelDensity = first.report.atlas.texelDensity / 2;
  options.udim = true;
  const UnwrapResult next = stackedExactly(mesh, options);
  for (std::size_t f = 0; f < 6; ++f) CHECK(placesOf(mesh, next, f) == placesOf(mesh, first, f));
}

TEST_CASE("a stacked layout can be kept in place, mirrored charts too", "[stack]") {
  const PolygonMesh mesh = copies(wedge(), 6, 5, true);
  UnwrapOptions options = stacking(Stack::Mirrored);
  const UnwrapResult first = stackedExactly(mesh, options);
  REQUIRE(first.report.atlas.stackedMirrored > 0);
  options.reuse.known = knownLayout(first);
  options.reuse.keepsPlaces = true;
  options.seams.isAuto = false;
  options.seams.edges = first.seams;
  const UnwrapResult kept = stackedExactly(mesh, options);
  CHECK(kept.uv == first.uv);
  CHECK(kept.report.atlas.stackedCharts == first.report.atlas.stackedCharts);
  CHECK(kept.report.atlas.stackedMirrored == first.report.atlas.stackedMirrored);
  CHECK(kept.report.atlas.utilization == Approx(first.report.atlas.utilization));
  // The same places overlap if nothing may be stacked.
  options.stack = Stack::None;
  CHECK_FALSE(unwrap(mesh, options).value().report.valid);
  // All charts may be locked.
  options.stack = Stack::Mirrored;
  for (std::uint32_t c = 0; c < first.report.charts.size(); ++c)
    options.reuse.fixedCharts.push_back(c);
  CHECK(stackedExactly(mesh, options).uv == first.uv);
  options.reuse.keepsPlaces = false;
  CHECK(stackedExactly(mesh, options).uv == first.uv);
}

TEST_CASE("stacks use as many tiles as their models need", "[stack]") {
  const PolygonMesh mesh = copies(wedge(), 5, 8);
  UnwrapOptions options = stacking(Stack::Identical);
  options.udim = true;
  options.texelDensity = 60;
  const UnwrapResult on = stackedExactly(mesh, options);
  options.stack = Stack::None;
  const UnwrapResult apart = unwrapped(mesh, options);
  CHECK(on.report.atlas.tiles > 1);
  CHECK(on.report.atlas.tiles < apart.report.atlas.tiles);
  CHECK(on.report.atlas.texelDensity == apart.report.atlas.texelDensity);
}

TEST_CASE("charts that are cut for packing are cut alike", "[stack]") {
  UnwrapOptions options = stacking(Stack::Mirrored);
  options.minUtilization = 0.9;
  const UnwrapResult result = stackedExactly(copies(bumpyGrid(80, 2, 0.2, 3), 6, 3, true), options);
  CHECK(result.report.atlas.packingCuts > 0);
  CHECK(result.report.charts.size() == 6 * placesIn(result));
}

TEST_CASE("pieces of a chart that is cut for packing are stacked as well", "[stack]") {
  // A long strip of squares.
  PolygonMesh strip;
  strip.faceOffsets = {0};
  for (std::uint32_t k = 0; k <= 96; ++k) {
    const double x = k;
    strip.positions.insert(strip.positions.end(), {x, 0, 0, x, 1, 0});
    if (k == 0) continue;
    for (const std::uint32_t v : {2 * k - 2, 2 * k, 2 * k + 1, 2 * k - 1})
      strip.faceVertices.push_back(v);
    strip.faceOffsets.push_back(4 * k);
  }
  UnwrapOptions options = stacking(Stack::Identical);
  options.minUtilization = kAutoMinUtilization;
  const UnwrapResult result = stackedExactly(strip, options);
  REQUIRE(result.report.atlas.packingCuts > 0);
  // Their lengths differ by one square or not at all.
  CHECK(placesIn(result) <= 2);
}

TEST_CASE("copies of steps that are taken for smooth are measured as they are", "[stack]") {
  const PolygonMesh mesh = copies(stairs(40), 3, 5, true);
  UnwrapOptions options = stacking(Stack::Mirrored);
  options.resolution = 64;
  const UnwrapResult result = stackedExactly(mesh, options);
  REQUIRE(result.report.notes.size() == 1);
  CHECK_THAT(result.report.notes[0], Catch::Contains("taken for smooth"));
  const std::vector<UnwrapChart>& charts = result.report.charts;
  REQUIRE(placesIn(result) == 1);
  for (const UnwrapChart& chart : charts) {
    CHECK(chart.area == Approx(2 * 40 * 40));
    CHECK(chart.symmetricDirichlet > 1.05);
    CHECK(chart.symmetricDirichlet == Approx(charts[0].symmetricDirichlet).epsilon(1e-3));
  }
}

TEST_CASE("straight seams and rounding keep stacks exact", "[stack]") {
  const PolygonMesh mesh = copies(wedge(), 5, 8, true);
  UnwrapOptions options = stacking(Stack::Mirrored);
  options.straightSeams = true;
  stackedExactly(mesh, options);
  options.straightSeams = false;
  options.precision = Precision::Single;
  stackedExactly(mesh, options);
  options.precision = Precision::Gltf;
  stackedExactly(mesh, options);
}

TEST_CASE("renumbered meshes have as many stacked charts", "[stack]") {
  const PolygonMesh mesh = copies(wedge(), 6, 5, true);
  for (const Stack stack : {Stack::Identical, Stack::Mirrored}) {
    const AtlasReport first = stackedExactly(mesh, stacking(stack)).report.atlas;
    const AtlasReport other =
        stackedExactly(renumbered(mesh, 4).mesh, stacking(stack)).report.atlas;
    CHECK(first.stackedCharts == other.stackedCharts);
    CHECK(first.stackedMirrored == other.stackedMirrored);
    CHECK(first.texelDensity == Approx(other.texelDensity).epsilon(0.02));
  }
}

TEST_CASE("without copies, stacking changes nothing", "[stack]") {
  for (const PolygonMesh& mesh : {wedge(), bumpyGrid(8, 6, 0.6, 4)}) {
    const UnwrapResult none = unwrapped(mesh, stacking(Stack::None));
    const UnwrapResult all = unwrapped(mesh, stacking(Stack::Mirrored));
    if (all.report.atlas.stackedCharts > 0) continue;
    CHECK(all.uv == none.uv);
    CHECK(all.report.seams.relativeLength == none.report.seams.relativeLength);
  }
}

TEST_CASE("a copy whose own diagonals fold in the layout of its model is left apart", "[stack]") {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-1.2, 1.2);
  constexpr int kPairs = 400;
  PolygonMesh mesh;
  for (int k = 0; k < kPairs; ++k) {
    // A bent quad, and a copy that begins at the next corner, so that it is split the other way.
    const double size = 1 + 0.01 * k;
    PolygonMesh quad;
    quad.positions = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
    for (double& x : quad.positions) x = size * (x + place(random));
    quad.faceVertices = {0, 1, 2, 3};
    quad.faceOffsets = {0, 4};
    append(mesh, moved(quad, randomMotion(random, false), false));
    quad.faceVertices = {1, 2, 3, 0};
    append(mesh, moved(quad, randomMotion(random, false), false));
  }
  const UnwrapResult result = stackedExactly(mesh, stacking(Stack::Identical));
  CHECK(result.report.atlas.stackedCharts < kPairs);
  CHECK(result.report.atlas.stackedCharts > 0.9 * kPairs);
}
