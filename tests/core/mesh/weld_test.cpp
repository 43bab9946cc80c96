#include "mesh/weld.h"

#include <cmath>
#include <random>

#include "abflat/unwrap.h"
#include "catch.h"
#include "support/instrumented.h"
#include "support/meshes.h"

using namespace abflat;
using namespace abflat::test;

namespace {

/// The same by comparing all pairs.
std::vector<std::uint32_t> weldedByPairs(const std::vector<double>& p, double reach) {
  std::vector<std::uint32_t> of(p.size() / 3);
  for (std::uint32_t v = 0; v < of.size(); ++v) {
    of[v] = v;
    for (std::uint32_t u = 0; u < v && of[v] == v; ++u) {
      if (of[u] != u) continue;
      const double x = p[3 * u] - p[3 * v], y = p[3 * u + 1] - p[3 * v + 1],
                   z = p[3 * u + 2] - p[3 * v + 2];
      if (std::sqrt(x * x + y * y + z * z) <= reach) of[v] = u;
    }
  }
  return of;
}

}  // namespace

TEST_CASE("vertices at one place become the first of them") {
  const Welding w = weldVertices({0, 0, 0, 1, 0, 0, 0, 0, 0, -0.0, 0, 0, 1, 0, 1e-9});
  CHECK(w.ofVertex == std::vector<std::uint32_t>{0, 1, 0, 0, 1});
  CHECK(w.merged == 3);
}

TEST_CASE("welding agrees with the comparison of all pairs, and does not depend on the unit") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(0, 1), shift(-1, 1);
  constexpr double kTolerance = 1e-3;
  std::vector<double> p{0, 0, 0, 1, 1, 1};  // makes the diagonal known
  for (int cluster = 0; cluster < 60; ++cluster) {
    const double at[3] = {place(random), place(random), place(random)};
    // Pairs are either clearly within the tolerance or clearly not.
    for (int i = 0; i < 4; ++i)
      for (const double x : at)
        p.push_back(std::clamp(x + (i < 3 ? 0.2 : 5) * kTolerance * shift(random), 0.0, 1.0));
  }
  const std::vector<std::uint32_t> wanted = weldedByPairs(p, kTolerance * std::sqrt(3.0));
  for (const double unit : {1.0, 1e-6, 1e6, 1e-300, 1e300}) {
    std::vector<double> q = p;
    for (double& x : q) x *= unit;
    CHECK(weldVertices(q, kTolerance).ofVertex == wanted);
  }
}

TEST_CASE("many vertices at one place, none, and one") {
  CHECK(weldVertices({}).merged == 0);
  CHECK(weldVertices({1, 2, 3}).ofVertex == std::vector<std::uint32_t>{0});
  const Welding w = weldVertices(std::vector<double>(3 * 50000, 4.0));
  CHECK(w.merged == 49999);
}

namespace {

/// Separate triangles of a mesh, with their corners displaced at random.
PolygonMesh shakenSoup(const PolygonMesh& mesh, double by) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> shift(-by, by);
  std::vector<double> p;
  std::vector<std::uint32_t> t;
  for (const std::uint32_t v : mesh.faceVertices) {
    t.push_back(static_cast<std::uint32_t>(t.size()));
    for (std::size_t d = 0; d < 3; ++d) p.push_back(mesh.positions[3 * v + d] + shift(random));
  }
  return makeTriangleMesh(p, t);
}

}  // namespace

TEST_CASE("a soup whose corners differ by rounding is welded to its surface") {
  const PolygonMesh mesh = torus(12, 18);
  const Welding w = weldSurface(shakenSoup(mesh, 1e-8));
  CHECK_FALSE(w.isExact);
  CHECK(w.ofVertex.size() - w.merged == mesh.vertexCount());
  for (std::size_t c = 0; c < w.ofVertex.size(); ++c)
    for (std::size_t o = 0; o < c; ++o)
      if ((w.ofVertex[c] == w.ofVertex[o]) != (mesh.faceVertices[c] == mesh.faceVertices[o]))
        FAIL("corners " << c << " and " << o);
}

TEST_CASE("detail below the tolerance is kept where the surface is closed, and within a face") {
  // A tetrahedron whose apex is replaced by a tiny triangle; then only its base and that triangle.
  const double e = 1e-9;
  const std::vector<double> p{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, e, 0, 1, 0, e, 1};
  const PolygonMesh closed =
      makeTriangleMesh(p, {0, 2, 1, 0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4, 2, 0, 3, 2, 3, 5, 3, 4, 5});
  CHECK(weldVertices(p).merged == 2);
  CHECK(weldSurface(closed).merged == 0);
  const PolygonMesh loose = makeTriangleMesh(p, {0, 1, 2, 3, 4, 5});
  CHECK(weldSurface(loose).merged == 0);
}

TEST_CASE("a triangle far off merges nothing elsewhere") {
  // Two squares, one above the other; with the distant triangle, they are within the tolerance of
  // each other.
  for (const double gap : {0.01, 1e-12}) {
    std::vector<double> p;
    for (const double z : {0.0, gap})
      for (const double y : {0.0, 1.0})
        for (const double x : {0.0, 1.0}) p.insert(p.end(), {x, y, z});
    const std::vector<std::uint32_t> t{0, 1, 3, 0, 3, 2, 5, 4, 6, 5, 6, 7};
    const std::size_t alone = weldSurface(makeTriangleMesh(p, t)).merged;
    CHECK(alone == (gap < 1e-6 ? 4 : 0));
    for (const double far : {1e6, 1e7, 1e9}) {
      std::vector<double> q = p;
      q.insert(q.end(), {far, 0, 0, far, far, 0, far, 0, far});
      std::vector<std::uint32_t> more = t;
      more.insert(more.end(), {8, 9, 10});
      CHECK(weldSurface(makeTriangleMesh(q, more)).merged == alone);
    }
  }
}

TEST_CASE("two closed surfaces that are nearly in touch stay two") {
  PolygonMesh mesh = tetrahedron();
  const std::size_t n = mesh.vertexCount();
  std::vector<double> p = mesh.positions;
  std::vector<std::uint32_t> t = mesh.faceVertices;
  for (std::size_t v = 0; v < n; ++v)
    for (std::size_t d = 0; d < 3; ++d)
      p.push_back(mesh.positions[3 * v + d] + (d == 0 ? 1e-9 : 0));
  for (const std::uint32_t v : mesh.faceVertices) t.push_back(v + static_cast<std::uint32_t>(n));
  CHECK(weldSurface(makeTriangleMesh(p, t)).merged == 0);
}

TEST_CASE("many vertices are welded as few are, however they are spread") {
  // All within the tolerance of each other, or nearly: in a cluster beside a distant vertex, and in
  // clusters of clusters.
  std::mt19937 random(11);
  std::uniform_real_distribution<double> place(0, 1);
  for (const double side : {1e-3, 1e-5, 6e-6, 1e-6, 1e-9}) {
    std::vector<double> p;
    for (std::size_t i = 0; i < 100000; ++i)
      for (std::size_t d = 0; d < 3; ++d)
        p.push_back(side * place(random) + (i % 2 ? 1e-3 * side * place(random) : 0));
    p.insert(p.end(), {1, 0, 0});
    const Welding w = weldVertices(p);
    std::size_t wrong = 0;
    for (std::size_t v = 0; v < w.ofVertex.size(); ++v) {
      const std::size_t u = w.ofVertex[v];
      double square = 0;
      for (std::size_t d = 0; d < 3; ++d)
        square += (p[3 * u + d] - p[3 * v + d]) * (p[3 * u + d] - p[3 * v + d]);
      wrong += u > v || w.ofVertex[u] != u || !(square <= 1.001 * w.reach * w.reach);
    }
    CHECK(wrong == 0);
    CHECK(weldEqualVertices(p).merged == 0);
  }
}

TEST_CASE("one face of many corners that are nearly at one place by twos") {
  // Like loose edges of a polygon; no two vertices of one face are merged.
  std::vector<double> p;
  std::vector<std::uint32_t> corners(40000);
  for (std::uint32_t k = 0; k < corners.size(); ++k) {
    const double angle = 6.283185307179586 * (k / 2) / 20000.0 + 1e-9 * (k % 2);
    p.insert(p.end(), {std::cos(angle), std::sin(angle), 0});
    corners[k] = k;
  }
  PolygonMesh mesh = makeTriangleMesh(p, {});
  mesh.faceVertices = corners;
  mesh.faceOffsets = {0, static_cast<std::uint32_t>(corners.size())};
  CHECK(weldVertices(p).merged == corners.size() / 2);
  CHECK(weldSurface(mesh).merged == 0);
}

namespace {

/// Both meshes as objects of one, vertex by vertex in turn as far as that goes.
PolygonMesh objectsOf(const PolygonMesh& a, const PolygonMesh& b) {
  PolygonMesh out;
  const std::size_t most = std::max(a.vertexCount(), b.vertexCount());
  std::vector<std::uint32_t> number[2];
  for (std::size_t v = 0; v < most; ++v)
    for (const PolygonMesh* mesh : {&a, &b}) {
      if (v >= mesh->vertexCount()) continue;
      const bool isSecond = mesh == &b;
      number[isSecond].push_back(static_cast<std::uint32_t>(out.vertexCount()));
      for (std::size_t d = 0; d < 3; ++d) out.positions.push_back(mesh->positions[3 * v + d]);
      out.vertexObjects.push_back(isSecond ? 7 : 4);
    }
  for (const PolygonMesh* mesh : {&a, &b})
    for (const std::uint32_t v : mesh->faceVertices)
      out.faceVertices.push_back(number[mesh == &b][v]);
  for (std::uint32_t c = 0; c <= out.faceVertices.size(); c += 3) out.faceOffsets.push_back(c);
  return out;
}

}  // namespace

TEST_CASE("objects that touch stay apart, and each is welded as it is alone") {
  // The second one is in the same place, so that every vertex and every edge has a double.
  for (const double noise : {0.0, 1e-8}) {
    const PolygonMesh mesh = torus(12, 18);
    const PolygonMesh a = noise > 0 ? shakenSoup(mesh, noise) : exploded(mesh);
    const PolygonMesh both = objectsOf(a, exploded(mesh));
    const Welding alone = weldSurface(a), w = weldSurface(both);
    CHECK(w.merged == 2 * alone.merged);
    for (std::uint32_t v = 0; v < w.ofVertex.size(); ++v)
      if (w.ofVertex[v] % 2 != v % 2) FAIL("vertex " << v << " is merged with " << w.ofVertex[v]);
    for (std::uint32_t v = 0; v < alone.ofVertex.size(); ++v)
      CHECK(w.ofVertex[2 * v] == 2 * alone.ofVertex[v]);
  }
}

TEST_CASE("no chart has faces of two objects") {
  // Two tetrahedra with a face in common, on its two sides.
  const PolygonMesh one =
      makeTriangleMesh({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3});
  const PolygonMesh other =
      makeTriangleMesh({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, -1}, {0, 1, 2, 0, 3, 1, 0, 2, 3, 1, 3, 2});
  PolygonMesh both = objectsOf(one, other);
  UnwrapOptions options;
  options.resolution = 256;
  options.maxStretch = 3;
  const Result<UnwrapResult> apart = unwrap(both, options);
  REQUIRE(apart.ok());
  CHECK(apart.value().report.valid);
  CHECK(apart.value().report.repair.mergedVertices == 0);
  std::vector<std::uint32_t> objectOf(apart.value().report.charts.size(), 0);
  for (std::size_t f = 0; f < both.faceCount(); ++f) {
    std::uint32_t& object = objectOf[apart.value().chartOfFace[f]];
    const std::uint32_t here = both.vertexObjects[both.faceVertices[3 * f]];
    CHECK((object == 0 || object == here));
    object = here;
  }
  both.vertexObjects = {};
  CHECK(unwrap(both, options).value().report.repair.mergedVertices == 3);

  both.vertexObjects = {1, 1};
  CHECK(unwrap(both, options).status().code == StatusCode::InvalidMesh);
}

TEST_CASE("vertices that no face uses are not there", "[unused]") {
  const PolygonMesh mesh = shakenSoup(torus(cases(8u, 5u), cases(6u, 4u)), 1e-8);
  const Welding wanted = weldSurface(mesh);
  std::mt19937 random(2);
  for (const double far : {0.0, 1.0, 1e9, 1e300}) {
    // Adds one vertex before each: at its place, near it, or anywhere.
    PolygonMesh more;
    more.faceOffsets = mesh.faceOffsets;
    for (std::size_t v = 0; v < mesh.vertexCount(); ++v) {
      for (std::size_t d = 0; d < 3; ++d)
        more.positions.push_back(mesh.positions[3 * v + d] +
                                 far * (static_cast<double>(random() % 1000) / 500 - 1));
      for (std::size_t d = 0; d < 3; ++d) more.positions.push_back(mesh.positions[3 * v + d]);
    }
    for (const std::uint32_t v : mesh.faceVertices) more.faceVertices.push_back(2 * v + 1);
    const Welding w = weldSurface(more);
    CHECK(w.merged == wanted.merged);
    CHECK(w.isExact == wanted.isExact);
    CHECK(w.reach == wanted.reach);
    for (std::uint32_t v = 0; v < mesh.vertexCount(); ++v) {
      CHECK(w.ofVertex[2 * v] == 2 * v);
      CHECK(w.ofVertex[2 * v + 1] == 2 * wanted.ofVertex[v] + 1);
    }
    UnwrapOptions options;
    options.resolution = 256;
    const Result<UnwrapResult> plain = unwrap(mesh, options), stray = unwrap(more, options);
    REQUIRE(plain.ok());
    REQUIRE(stray.ok());
    CHECK(stray.value().uv == plain.value().uv);
    CHECK(stray.value().cornerUv == plain.value().cornerUv);
    CHECK(stray.value().report.repair.mergedVertices == plain.value().report.repair.mergedVertices);
  }
}
