#include "flatten/planar.h"

#include <cmath>
#include <functional>

#include "abflat/unwrap.h"
#include "catch.h"
#include "support/meshes.h"
#include "support/problems.h"

using namespace abflat;
using namespace abflat::test;

namespace {

/// Squares with these indices, of a grid in a plane that is turned by `angle` and tilted.
PolygonMesh sheet(unsigned n, double angle,
                  const std::function<bool(unsigned, unsigned)>& isThere) {
  PolygonMesh mesh;
  for (unsigned i = 0; i <= n; ++i)
    for (unsigned j = 0; j <= n; ++j) {
      const double x = i + 0.2 * std::sin(3.0 * j), y = j + 0.2 * std::sin(2.0 * i);
      const double u = x * std::cos(angle) - y * std::sin(angle);
      const double v = x * std::sin(angle) + y * std::cos(angle);
      mesh.positions.insert(mesh.positions.end(), {u, v * std::cos(angle), v * std::sin(angle)});
    }
  mesh.faceOffsets = {0};
  const auto face = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    mesh.faceVertices.insert(mesh.faceVertices.end(), {a, b, c});
    mesh.faceOffsets.push_back(static_cast<std::uint32_t>(mesh.faceVertices.size()));
  };
  for (unsigned i = 0; i < n; ++i)
    for (unsigned j = 0; j < n; ++j) {
      if (!isThere(i, j)) continue;
      const std::uint32_t a = i * (n + 1) + j;
      face(a, a + n + 1, a + n + 2);
      face(a, a + n + 2, a + 1);
    }
  return mesh;
}

bool isAll(unsigned, unsigned) { return true; }

/// A floor, and the sliver that closes a T-junction in its long side.
PolygonMesh withSliver(double height) {
  PolygonMesh mesh;
  mesh.positions = {0, 28, 0, -11, 0, 0, -height, 0, 0, 0, 14, 0};
  mesh.faceVertices = {0, 1, 2, 3, 0, 2};
  mesh.faceOffsets = {0, 3, 6};
  return mesh;
}

}  // namespace

TEST_CASE("the layout of a flat chart keeps all lengths, wherever its plane is") {
  const auto isL = [](unsigned i, unsigned j) { return i < 2 || j < 2; };
  for (const double angle : {0.0, 0.4, 1.9, 3.3})
    for (const auto& isThere : {std::function<bool(unsigned, unsigned)>(isAll),
                                std::function<bool(unsigned, unsigned)>(isL)}) {
      const DiskChart chart = chartOf(sheet(6, angle, isThere));
      const std::optional<Attempt> flat = projectPlanar(chart);
      REQUIRE(flat);
      CHECK(checkSeparated(chart, flat->uv).valid());
      CHECK(flat->distortion.symmetricDirichlet == Approx(1).margin(1e-12));
      CHECK(flat->distortion.length < 1e-20);
      CHECK(flat->solver == Solver::Projection);
    }
}

TEST_CASE("slivers do not keep a flat chart from being projected") {
  for (const double height : {1e-3, 1e-5, 2.4e-7, 1e-9}) {
    const DiskChart chart = chartOf(withSliver(height));
    const std::optional<Attempt> flat = projectPlanar(chart);
    CAPTURE(height);
    REQUIRE(flat);
    CHECK(flat->validity.valid());
    CHECK(flat->distortion.symmetricDirichlet == Approx(1).margin(1e-9));
  }
}

TEST_CASE("what is bent or folded is not projected") {
  CHECK_FALSE(projectPlanar(chartOf(bumpyGrid(8, 8, 0.3, 1))));
  PolygonMesh folded = sheet(4, 0, isAll);
  // The last column is turned back over the others.
  for (unsigned j = 0; j <= 4; ++j) folded.positions[3 * (4 * 5 + j)] -= 1.8;
  CHECK_FALSE(projectPlanar(chartOf(folded)));
}

TEST_CASE("slivers in flat regions do not ruin an atlas", "[unwrap]") {
  for (const double height : {1e-4, 3e-6, 2.4e-7, 1e-8}) {
    UnwrapOptions options;
    options.precision = Precision::Single;
    const Result<UnwrapResult> r = unwrap(withSliver(height), options);
    CAPTURE(height);
    REQUIRE(r.ok());
    CHECK(r.value().report.valid);
    CHECK(r.value().report.charts.size() == 1);
    CHECK(r.value().report.symmetricDirichlet < 1 + 1e-6);
  }
}
