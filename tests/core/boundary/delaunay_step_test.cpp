#include "boundary/delaunay_step.h"

#include <cmath>
#include <random>

#include "abflat/flatten.h"
#include "abflat/samples.h"
#include "catch.h"
#include "check/delaunay.h"
#include "support/instrumented.h"
#include "support/meshes.h"
#include "support/problems.h"

using namespace abflat;
using namespace abflat::test;

namespace {

FlattenResult flattened(const PolygonMesh& mesh, double t, bool delaunay) {
  FlattenOptions options;
  options.t = t;
  options.delaunay = delaunay;
  Result<FlattenResult> r = flatten(mesh, options);
  INFO(r.status().message);
  REQUIRE(r.ok());
  return std::move(r.value());
}

/// Edges whose two opposite angles, measured in the layout, add up to more than pi beyond rounding.
std::size_t countViolated(const DiskChart& chart, const std::vector<double>& uv) {
  const auto angleAt = [&](ChartCorner corner) {
    const double* o = &uv[2 * chart.vertexOfCorner[corner]];
    const double* a = &uv[2 * chart.vertexOfCorner[nextCorner(corner)]];
    const double* b = &uv[2 * chart.vertexOfCorner[prevCorner(corner)]];
    const double x = a[0] - o[0], y = a[1] - o[1], z = b[0] - o[0], w = b[1] - o[1];
    return std::atan2(x * w - y * z, x * z + y * w);
  };
  std::size_t count = 0;
  for (const ChartCorner h : chart.corners())
    if (chart.twin[h].exists() && h < chart.twin[h])
      count +=
          angleAt(prevCorner(h)) + angleAt(prevCorner(chart.twin[h])) > 3.14159265358979 + 1e-7;
  return count;
}

/// A grid with a vertex in the middle of every triangle. The angles there need 2 pi, more than
/// condition (9) leaves them.
PolygonMesh stellatedGrid(unsigned side) {
  const PolygonMesh grid = bumpyGrid(side, side, 0.2, 1);
  PolygonMesh out;
  out.positions = grid.positions;
  out.faceOffsets = {0};
  for (std::size_t f = 0; f < grid.faceCount(); ++f) {
    const std::uint32_t* v = &grid.faceVertices[grid.faceOffsets[f]];
    const auto middle = static_cast<std::uint32_t>(out.positions.size() / 3);
    for (std::size_t i = 0; i < 3; ++i)
      out.positions.push_back((grid.positions[3 * v[0] + i] + grid.positions[3 * v[1] + i] +
                               grid.positions[3 * v[2] + i]) /
                              3);
    for (std::size_t k = 0; k < 3; ++k) {
      for (const std::uint32_t corner : {v[k], v[(k + 1) % 3], middle})
        out.faceVertices.push_back(corner);
      out.faceOffsets.push_back(static_cast<std::uint32_t>(out.faceVertices.size()));
    }
  }
  return out;
}

}  // namespace

TEST_CASE("a Delaunay layout has every interior edge Delaunay and distorts no less") {
  for (const double t : {kAutoT, 1.0})
    for (const unsigned seed : {1u, 2u, 3u}) {
      const PolygonMesh mesh = bumpyGrid(12, 10, 0.35, seed);
      const FlattenResult plain = flattened(mesh, t, false), r = flattened(mesh, t, true);
      const ChartReport& chart = r.report.charts.front();
      REQUIRE(chart.delaunay);
      CHECK_FALSE(plain.report.charts.front().delaunay);
      CHECK(chart.valid);
      CHECK(chart.delaunay->violatedBefore ==
            checkDelaunay(chartOf(mesh), plain.uv).violated.size());
      CHECK(chart.delaunay->violatedBefore > 0);
      CHECK(chart.delaunay->violated == 0);
      CHECK(chart.delaunay->resisting.empty());
      CHECK(checkDelaunay(chartOf(mesh), r.uv).violated.empty());
      CHECK(countViolated(chartOf(mesh), r.uv) == 0);
      CHECK(chart.angularDistortion >= chart.delaunay->angularDistortionBefore);
      CHECK(chart.delaunay->angularDistortionBefore ==
            Approx(plain.report.charts.front().angularDistortion));
      CHECK(chart.maxBoundaryAngle <= (t == kAutoT ? 2 : t) * 3.14159265358979 + 1e-9);
    }
}

TEST_CASE("every sample can be made Delaunay") {
  for (const Sample& sample : samples()) {
    INFO(sample.name);
    const PolygonMesh mesh = sample.make(1);
    const FlattenResult r = flattened(mesh, kAutoT, true);
    CHECK(r.report.valid);
    CHECK(r.report.charts.front().delaunay->violated == 0);
    CHECK(checkDelaunay(chartOf(mesh), r.uv).violated.empty());
  }
}

TEST_CASE("a layout that is Delaunay already stays as it is") {
  const PolygonMesh mesh = cone(7, 0.3);
  const FlattenResult plain = flattened(mesh, 1, false), r = flattened(mesh, 1, true);
  CHECK(r.report.charts.front().delaunay->violatedBefore == 0);
  CHECK(r.uv == plain.uv);
}

TEST_CASE("where the connectivity has no Delaunay layout the edges that resist are named") {
  const PolygonMesh mesh = stellatedGrid(4);
  const FlattenResult plain = flattened(mesh, 1, false), r = flattened(mesh, 1, true);
  const ChartReport& chart = r.report.charts.front();
  CHECK(chart.valid);
  CHECK(r.uv == plain.uv);
  REQUIRE(chart.delaunay);
  CHECK(chart.delaunay->violated == chart.delaunay->violatedBefore);
  CHECK(chart.delaunay->violated == checkDelaunay(chartOf(mesh), r.uv).violated.size());
  CHECK_FALSE(chart.delaunay->resisting.empty());
  // Only edges of the grid resist: those at a middle vertex have acute opposite angles.
  for (const auto& edge : chart.delaunay->resisting)
    for (const std::uint32_t v : edge) CHECK(v < 25);
  REQUIRE(chart.fallbacks.size() == 1);
  CHECK(chart.fallbacks.front().find("the layout is not Delaunay") == 0);
}

TEST_CASE("shared disks are made Delaunay") {
  for (const char* file : {"nefertiti.off", "hemisphere.obj", "body.off", "cathead.obj",
                           "mannequin.off", "face.obj", "camel-cut.obj", "cow-cut.off"}) {
    const PolygonMesh mesh = sharedMesh(file);
    if (mesh.faceCount() == 0) return;
    if (mesh.faceCount() > cases(100000u, 3000u)) continue;
    INFO(file);
    const FlattenResult r = flattened(mesh, kAutoT, true);
    CHECK(r.report.valid);
    CHECK(r.report.charts.front().delaunay->violated == 0);
  }
}

TEST_CASE("whether a mesh is made Delaunay does not depend on rounding") {
  PolygonMesh mesh = sharedMesh("mannequin.off");
  if (mesh.faceCount() == 0) return;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> noise(1 - 1e-9, 1 + 1e-9);
  for (int i = 0; i < 6; ++i) {
    for (double& x : mesh.positions) x *= noise(random);
    CHECK(flattened(mesh, kAutoT, true).report.charts.front().delaunay->violated == 0);
  }
}

TEST_CASE("the condition on adjacent boundary edges bounds a free boundary at a full turn") {
  for (const Sample& sample : samples()) {
    FlattenOptions options;
    options.t = 2;
    options.adjacent = true;
    const Result<FlattenResult> r = flatten(sample.make(1), options);
    REQUIRE(r.ok());
    CHECK(r.value().report.charts.front().maxBoundaryAngle < 2 * 3.14159265358979);
  }
}
