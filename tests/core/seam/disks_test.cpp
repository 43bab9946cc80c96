#include <cmath>
#include <random>

#include "catch.h"
#include "support/cut_meshes.h"
#include "support/instrumented.h"
#include "support/isosurface.h"
#include "support/meshes.h"

using namespace abflat;
using namespace abflat::test;

namespace {

void append(PolygonMesh& all, const PolygonMesh& one, double shift) {
  const auto first = static_cast<std::uint32_t>(all.vertexCount());
  std::vector<std::uint32_t> indices = all.faceVertices;
  for (std::size_t i = 0; i < one.positions.size(); ++i)
    all.positions.push_back(one.positions[i] + (i % 3 == 0 ? shift : 0));
  for (const std::uint32_t v : one.faceVertices) indices.push_back(first + v);
  all = makeTriangleMesh(std::move(all.positions), std::move(indices));
}

PolygonMesh box() {
  std::vector<double> p;
  for (unsigned i = 0; i < 8; ++i)
    p.insert(p.end(), {i & 1 ? 1. : 0., i & 2 ? 1. : 0., i & 4 ? 1. : 0.});
  return makeTriangleMesh(p, {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                              2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5});
}

/// Strip or tube of n quads around a circle, with its end joined to its beginning upside down.
PolygonMesh twisted(unsigned n, unsigned rows, bool isTube) {
  std::vector<double> p;
  std::vector<std::uint32_t> t;
  for (unsigned i = 0; i < n; ++i)
    for (unsigned j = 0; j < rows; ++j) {
      const double a = 6.283185307 * i / n, b = (isTube ? 6.283185307 : 2.) * j / rows + a / 2;
      p.insert(p.end(),
               {(3 + std::cos(b)) * std::cos(a), (3 + std::cos(b)) * std::sin(a), std::sin(b)});
    }
  const auto at = [&](unsigned i, unsigned j) {
    if (i < n) return i * rows + j % rows;
    return isTube ? (rows - j % rows) % rows : rows - 1 - j;
  };
  for (unsigned i = 0; i < n; ++i)
    for (unsigned j = 0; j + (isTube ? 0 : 1) < rows; ++j) {
      t.insert(t.end(), {at(i, j), at(i + 1, j), at(i, j + 1)});
      t.insert(t.end(), {at(i, j + 1), at(i + 1, j), at(i + 1, j + 1)});
    }
  return makeTriangleMesh(p, t);
}

PolygonMesh soup(unsigned vertices, unsigned triangles, unsigned seed, bool repeats) {
  std::mt19937 random(seed);
  std::vector<double> p;
  std::vector<std::uint32_t> t;
  for (unsigned i = 0; i < 3 * vertices; ++i)
    p.push_back(static_cast<double>(random() % 1000) / 100);
  while (t.size() < 3 * triangles) {
    const auto pick = [&] { return static_cast<std::uint32_t>(random() % vertices); };
    const std::uint32_t a = pick(), b = pick(), c = pick();
    if (repeats || (a != b && b != c && c != a)) t.insert(t.end(), {a, b, c});
  }
  return makeTriangleMesh(p, t);
}

Seams seamsOf(const Cuttable& c, Seams given = {}) {
  SeamReport report;
  Seams seams = findSeams(c.seamMesh, std::move(given), {}, &report);
  REQUIRE(seams.size() == c.seamMesh.twin.size());
  for (const SurfaceCorner h : seams.ids()) {
    if (!seams[h]) continue;
    REQUIRE(c.seamMesh.twin[h].exists());
    REQUIRE(seams[c.seamMesh.twin[h]]);
  }
  CHECK(std::isfinite(report.stretch));
  CHECK(std::isfinite(report.seamLength));
  CHECK(report.charts == chartsOf(c, seams).size());
  return seams;
}

void checkAllDisks(PolygonMesh mesh) {
  const Cuttable c(std::move(mesh));
  for (const PolygonMesh& chart : chartsOf(c, seamsOf(c))) {
    const MeshSummary summary = inspect(chart);
    INFO(summary.disk.message << " in a chart of " << summary.faces << " faces");
    REQUIRE(summary.components == 1);
    REQUIRE(summary.boundaryLoops == 1);
    REQUIRE(summary.eulerCharacteristic == 1);
    REQUIRE(summary.nonManifoldEdges + summary.orientationConflicts == 0);
  }
}

}  // namespace

TEST_CASE("every chart of a smooth surface is a disk", "[seams][quality]") {
  checkAllDisks(isosurface(20, rings(0)));
  for (const unsigned genus : {1u, 2u, 3u, 6u})
    if (genus <= cases(6u, 2u)) checkAllDisks(isosurface(12 + 6 * genus, rings(genus)));
  for (const unsigned seed : {1u, 2u, 3u}) checkAllDisks(isosurface(24, noise(4, seed)));
  checkAllDisks(torus(12, 30));
  checkAllDisks(cylinder(16, 5));
  checkAllDisks(bumpyGrid(12, 9, 2, 5));
}

TEST_CASE("every chart of the smallest surfaces is a disk", "[seams]") {
  checkAllDisks(makeTriangleMesh({0, 0, 0, 1, 0, 0, 0, 1, 0}, {0, 1, 2}));
  checkAllDisks(makeTriangleMesh({0, 0, 0, 1, 0, 0, 0, 1, 0}, {0, 1, 2, 0, 2, 1}));  // a pillow
  checkAllDisks(tetrahedron());
  checkAllDisks(box());
  for (const unsigned n : {3u, 4u, 20u}) checkAllDisks(cone(n, 3));
  checkAllDisks(star(7));
  // Two tetrahedra that touch at a vertex.
  PolygonMesh pair = tetrahedron();
  append(pair, tetrahedron(), 5);
  for (std::uint32_t& v : pair.faceVertices)
    if (v == 4) v = 0;
  checkAllDisks(pair);
}

TEST_CASE("every chart of an array of boxes is a disk", "[seams]") {
  PolygonMesh all;
  for (int i = 0; i < 300; ++i) append(all, i % 3 ? box() : tetrahedron(), 2.0 * i);
  checkAllDisks(all);
}

TEST_CASE("one-sided surfaces, cut open where they do not fit, become disks", "[seams]") {
  checkAllDisks(twisted(24, 5, false));
  checkAllDisks(twisted(24, 12, true));
}

TEST_CASE("every chart of a soup is a disk", "[seams]") {
  for (unsigned seed = 1; seed <= 60; ++seed) {
    CAPTURE(seed);
    checkAllDisks(soup(4 + seed % 9, 3 + seed % 40, seed, false));
  }
}

TEST_CASE("degenerate triangles neither hang nor spoil the seams of others", "[seams]") {
  PolygonMesh flat = bumpyGrid(10, 10, 1, 3);
  for (std::size_t v = 0; v < flat.vertexCount(); v += 3) flat.positions[3 * v + 2] = 0;
  for (std::size_t i = 0; i < 30; ++i) flat.positions[i] = 0;  // ten vertices at one point
  checkAllDisks(flat);
  PolygonMesh point = torus(6, 8);
  for (double& x : point.positions) x = 7;
  checkAllDisks(point);
  for (unsigned seed = 1; seed <= 30; ++seed) {
    const Cuttable c(soup(6, 12, seed, true));
    seamsOf(c);
  }
}

TEST_CASE("given seams are kept and completed", "[seams]") {
  for (unsigned seed = 1; seed <= 12; ++seed) {
    CAPTURE(seed);
    const Cuttable c(seed % 2 ? torus(8, 14) : isosurface(10, rings(0)));
    std::mt19937 random(seed);
    Seams given(c.seamMesh.twin.size(), 0);
    const unsigned share = seed < 3 ? 1000 : 1 + seed * 3;
    for (const SurfaceCorner h : given.ids())
      if (random() % share == 0) given[h] = given[c.seamMesh.twin[h]] = 1;
    if (seed == 2)
      given.assign(given.size(), 0), given[SurfaceCorner(0)] = 1;  // one side of one edge
    const Seams seams = seamsOf(c, given);
    for (const SurfaceCorner h : given.ids())
      if (given[h]) REQUIRE(seams[h]);
    for (const PolygonMesh& chart : chartsOf(c, seams)) {
      const MeshSummary summary = inspect(chart);
      INFO(summary.disk.message);
      REQUIRE(summary.disk.ok());
    }
  }
}
