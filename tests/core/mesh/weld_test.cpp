#include "mesh/weld.h"

#include <cmath>
#include <random>

#include "catch.h"
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
  std::vector<double> p{0, 0, 0, 1, 1, 1};  // so that the diagonal is known
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

/// Loose triangles of a mesh, their corners shaken.
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
  // A tetrahedron with its apex, then with a face, replaced by tiny ones.
  const double e = 1e-9;
  const std::vector<double> p{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, e, 0, 1, 0, e, 1};
  const PolygonMesh closed =
      makeTriangleMesh(p, {0, 2, 1, 0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4, 2, 0, 3, 2, 3, 5, 3, 4, 5});
  CHECK(weldVertices(p).merged == 2);
  CHECK(weldSurface(closed).merged == 0);
  const PolygonMesh loose = makeTriangleMesh(p, {0, 1, 2, 3, 4, 5});
  CHECK(weldSurface(loose).merged == 0);
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
