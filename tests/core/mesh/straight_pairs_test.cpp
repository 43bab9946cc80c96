#include "mesh/straight_pairs.h"

#include <algorithm>
#include <array>

#include "base/constants.h"
#include "base/portable_math.h"
#include "catch.h"
#include "mesh/surface.h"
#include "support/meshes.h"

using namespace abflat;
using namespace abflat::test;

namespace {

constexpr unsigned kRows = 5;

/// Strips of `kRows` squares that meet in one line, each towards an angle in degrees. Strips given
/// as `in` traverse that line the other way around, so each of them can go on in one given as
/// `out`.
PolygonMesh strips(const std::vector<double>& out, const std::vector<double>& in) {
  std::vector<double> positions;
  std::vector<std::uint32_t> triangles;
  for (unsigned y = 0; y <= kRows; ++y) positions.insert(positions.end(), {0, double(y), 0});
  const auto add = [&](double degrees, bool isIn) {
    const auto first = static_cast<std::uint32_t>(positions.size() / 3);
    const double angle = degrees * kPi / 180;
    for (unsigned y = 0; y <= kRows; ++y)
      positions.insert(positions.end(), {portable::cos(angle), double(y), portable::sin(angle)});
    for (std::uint32_t y = 0; y < kRows; ++y) {
      std::array<std::uint32_t, 6> t{y, y + 1, first + y, first + y, y + 1, first + y + 1};
      if (isIn) std::reverse(t.begin(), t.end());
      triangles.insert(triangles.end(), t.begin(), t.end());
    }
  };
  for (const double angle : out) add(angle, false);
  for (const double angle : in) add(angle, true);
  return makeTriangleMesh(positions, triangles);
}

/// Pairs at each edge of the line, which all have the same, and the pieces of the surface.
struct Joined {
  std::size_t pairs, components;
};
Joined joined(const PolygonMesh& mesh) {
  const Surface s = buildSurface(mesh);
  REQUIRE(s.table.nonManifold.size() == kRows);
  const std::size_t pairs = s.table.nonManifold.front().pairs;
  for (const BadEdge& edge : s.table.nonManifold) CHECK(edge.pairs == pairs);
  for (const SurfaceCorner h : s.table.corners()) {
    const SurfaceCorner t = s.table.twin[h];
    if (!t.exists()) continue;
    CHECK(s.table.twin[t] == h);
    CHECK(s.table.vertex[t] == s.table.vertex[nextCorner(h)]);
  }
  return {pairs, s.summary.components};
}

}  // namespace

TEST_CASE("a surface goes on where something stands on it") {
  for (const double fin : {60., 90., 130.}) {
    const Joined found = joined(strips({0}, {180, fin}));
    CHECK(found.pairs == 1);
    CHECK(found.components == 2);
  }
}

TEST_CASE("two surfaces that cross both go on") {
  for (const double turn : {40., 90., 110.})
    for (const double bend : {0., 20., -30.}) {
      const Joined found = joined(strips({0, turn}, {180 + bend, 180 + turn}));
      CHECK(found.pairs == 2);
      CHECK(found.components == 2);
    }
}

TEST_CASE("two pairs are better than the one that bends least") {
  const Joined found = joined(strips({0, 25}, {190, 140}));
  CHECK(found.pairs == 2);
  CHECK(found.components == 2);
}

TEST_CASE("faces that nothing but their numbers could choose between stay cut") {
  CHECK(joined(strips({0}, {120, 240})).pairs == 0);
  CHECK(joined(strips({0}, {150, 210})).pairs == 0);
  CHECK(joined(strips({0, 90}, {180 + 45, 180 + 45.0 + 1e-9})).pairs == 0);
}

TEST_CASE("faces that bend much, or are seen from the other side, stay cut") {
  CHECK(joined(strips({0}, {90, 80})).pairs == 0);
  CHECK(joined(strips({0, 180, 90}, {})).pairs == 0);
}

TEST_CASE("a surface is counted as before where it goes on") {
  for (const PolygonMesh& mesh : {strips({0}, {180, 90}), strips({0, 90}, {180, 270}),
                                  strips({0}, {120, 240}), strips({0, 90}, {180, 270, 300})}) {
    const MeshSummary m = inspect(mesh);
    const std::size_t strip = mesh.faceCount() / (2 * kRows);
    CHECK(m.nonManifoldEdges == kRows);
    CHECK(m.boundaryEdges == strip * (kRows + 2));
    CHECK(m.eulerCharacteristic == 1);
    CHECK(m.disk.code == StatusCode::NonManifoldEdge);
  }
}

TEST_CASE("which faces are joined does not depend on their numbers") {
  const PolygonMesh mesh = strips({0, 70, 200}, {175, 245, 20});
  const Joined wanted = joined(mesh);
  CHECK(wanted.pairs == 3);
  for (unsigned seed = 1; seed < 6; ++seed) {
    const Joined found = joined(renumbered(mesh, seed).mesh);
    CHECK(found.pairs == wanted.pairs);
    CHECK(found.components == wanted.components);
  }
}

namespace {

constexpr std::uint32_t kLong = 14, kWide = 5;

/// A surface folded at a right angle along a line, and a band that goes straight on from its first
/// half. The faces of each of the three follow each other.
PolygonMesh foldWithFin() {
  std::vector<double> positions;
  const std::uint32_t row = 2 * kWide + 2;
  for (std::uint32_t y = 0; y <= kLong; ++y) {
    for (std::uint32_t i = 0; i <= 2 * kWide; ++i) {
      const double x = double(i) - kWide;
      positions.insert(positions.end(), {std::min(x, 0.), double(y), -std::max(x, 0.)});
    }
    positions.insert(positions.end(), {1, double(y), 0});
  }
  std::vector<std::uint32_t> triangles;
  const auto band = [&](std::uint32_t from, std::uint32_t to) {
    for (std::uint32_t y = 0; y < kLong; ++y) {
      const std::uint32_t a = y * row + from, b = y * row + to;
      triangles.insert(triangles.end(), {a, b, b + row, a, b + row, a + row});
    }
  };
  for (std::uint32_t i = 0; i < 2 * kWide; ++i) band(i, i + 1);
  band(kWide, 2 * kWide + 1);
  return makeTriangleMesh(positions, triangles);
}

/// How many of the edges in the middle of the line join the halves of the fold, and how many the
/// first half and the band.
struct Across {
  int fold = 0, fin = 0;
};
Across across(const PolygonMesh& mesh, double fine) {
  const Surface s = buildSurface(mesh, {}, [fine](const CornerTable&) { return fine; });
  REQUIRE(s.table.nonManifold.size() == kLong);
  const auto placeOf = [&](SurfaceCorner h) {
    const SurfaceTriangle f = triangleOf(h);
    double x = 0, z = 0;
    for (const std::uint32_t v : verticesOf(s.table.vertex, f)) {
      x += mesh.positions[3 * std::size_t{v}];
      z += mesh.positions[3 * std::size_t{v} + 2];
    }
    return x < 0 ? 0 : z < 0 ? 1 : 2;
  };
  Across out;
  for (const SurfaceCorner h : s.table.nonManifoldCorners) {
    const double y = mesh.positions[3 * std::size_t{s.table.vertex[h]} + 1];
    if (placeOf(h) != 0 || y < 5 || y > kLong - 5 || !s.table.twin[h].exists()) continue;
    ++(placeOf(s.table.twin[h]) == 1 ? out.fold : out.fin);
  }
  return out;
}

}  // namespace

TEST_CASE("at fine edges a surface goes on around a step, and what ends there is cut off") {
  const PolygonMesh mesh = foldWithFin();
  const Across coarse = across(mesh, 0.5), fine = across(mesh, 2);
  CHECK(coarse.fold == 0);
  CHECK(coarse.fin >= 4);
  CHECK(fine.fold == coarse.fin);
  CHECK(fine.fin == 0);
}

TEST_CASE("where all surfaces end soon, fine edges are like others") {
  for (const PolygonMesh& mesh : {strips({0}, {180, 90}), strips({0, 90}, {180, 270})}) {
    const Surface coarse = buildSurface(mesh),
                  fine = buildSurface(mesh, {}, [](const CornerTable&) { return 10.0; });
    CHECK(fine.table.twin == coarse.table.twin);
  }
}
