#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <vector>

#include "abflat/unwrap.h"
#include "base/constants.h"
#include "catch.h"
#include "support/meshes.h"
#include "support/unwrapped.h"

using namespace abflat;
using namespace abflat::test;

namespace {

/// A capsule as modelling libraries make it: rows of n + 1 vertices from pole to pole, so that the
/// first and the last of each row coincide, and quads of two triangles everywhere, one of which has
/// no area at a pole. `apart`: radius of the rows at the poles.
PolygonMesh capsule(unsigned n, double apart) {
  std::vector<double> p;
  std::vector<std::uint32_t> t;
  const unsigned rows = 2 * n;
  for (unsigned j = 0; j <= rows; ++j)
    for (unsigned i = 0; i <= n; ++i) {
      const double down = kPi * j / rows, around = 2 * kPi * (i % n) / n;
      const double radius = j % rows == 0 ? apart : std::sin(down);
      const double height = std::cos(down) + (2 * j < rows ? 0.5 : -0.5);
      p.insert(p.end(), {radius * std::cos(around), height, radius * std::sin(around)});
    }
  for (unsigned j = 0; j < rows; ++j)
    for (unsigned i = 0; i < n; ++i) {
      const std::uint32_t a = j * (n + 1) + i, b = a + n + 1;
      t.insert(t.end(), {a, a + 1, b});
      t.insert(t.end(), {a + 1, b + 1, b});
    }
  return makeTriangleMesh(std::move(p), std::move(t));
}

}  // namespace

TEST_CASE("poles of triangles without area cost no charts", "[unwrap]") {
  for (const unsigned n : {6, 20, 48})
    for (const double apart : {0.0, 6e-17}) {
      INFO(n << ", " << apart);
      UnwrapOptions options;
      options.minUtilization = 0;
      const UnwrapResult r = unwrapped(capsule(n, apart), options);
      CHECK(r.report.charts.size() == 1);
      CHECK(r.report.symmetricDirichlet <= options.maxStretch);
      CHECK(r.report.seams.relativeLength < 2);
    }
}

TEST_CASE("no vertex inside of a chart has two triangles only", "[unwrap]") {
  // A face that runs along a line and back again, around a vertex on it.
  PolygonMesh mesh;
  mesh.positions = {-2, 2, 0, -2, -1, 0, -1, -1, 0, 0, -1, 0};
  mesh.faceVertices = {3, 2, 1, 3, 1, 0, 2};
  mesh.faceOffsets = {0, 7};
  const UnwrapResult r = unwrapped(mesh, {});
  std::map<std::uint32_t, int> triangles;
  std::map<std::array<std::uint32_t, 2>, int> sides;
  for (std::size_t c = 0; c < r.triangles.size(); ++c) {
    const std::uint32_t a = r.triangles[c], b = r.triangles[c % 3 == 2 ? c - 2 : c + 1];
    ++triangles[a];
    ++sides[{std::min(a, b), std::max(a, b)}];
  }
  std::set<std::uint32_t> boundary;
  for (const auto& [edge, count] : sides)
    if (count == 1) boundary.insert(edge.begin(), edge.end());
  for (const auto& [vertex, count] : triangles) CHECK((count > 2 || boundary.count(vertex) == 1));
  CHECK(r.report.symmetricDirichlet <= UnwrapOptions().maxStretch);
}

TEST_CASE("holes that stay filled may lie at the outline of their chart", "[unwrap]") {
  UnwrapOptions options;
  options.fillHoles = FillHoles::Always;
  // Every fifth square is missing.
  PolygonMesh mesh = bumpyGrid(12, 12, 0.3, 5);
  std::vector<std::uint32_t> kept;
  for (std::size_t i = 0; i < mesh.faceVertices.size(); i += 6)
    if ((i / 6 / 12 + 2 * (i / 6 % 12)) % 5 != 0)
      kept.insert(kept.end(), mesh.faceVertices.begin() + static_cast<std::ptrdiff_t>(i),
                  mesh.faceVertices.begin() + static_cast<std::ptrdiff_t>(i) + 6);
  unwrapped(makeTriangleMesh(mesh.positions, kept), options);
  for (const char* file : {"teapot-5parts.obj", "beetle-nonmanifold.obj", "halftunnel-quads.off"})
    if (const PolygonMesh shared = sharedMesh(file); shared.faceCount() > 0)
      unwrapped(shared, options);
}
