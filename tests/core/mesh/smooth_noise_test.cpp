#include "mesh/smooth_noise.h"

#include <algorithm>
#include <cmath>

#include "catch.h"
#include "mesh/triangle_geometry.h"
#include "support/meshes.h"
#include "support/squares.h"

using namespace abflat;
using namespace abflat::test;

namespace {

Smoothed smoothed(const PolygonMesh& mesh, double reach) {
  return smoothNoise(mesh, buildSurface(mesh), reach);
}

double totalArea(const PolygonMesh& mesh, const std::vector<double>& positions) {
  double sum = 0;
  for (std::uint32_t f = 0; f < mesh.faceCount(); ++f)
    sum += areaOf(positions, {mesh.faceVertices[3 * f], mesh.faceVertices[3 * f + 1],
                              mesh.faceVertices[3 * f + 2]});
  return sum;
}

/// Two planes at a right angle.
PolygonMesh roof(std::uint32_t n) {
  PolygonMesh mesh = squares(2 * n, n, [](auto, auto) { return true; });
  for (std::size_t v = 0; v < mesh.vertexCount(); ++v)
    mesh.positions[3 * v + 2] = std::abs(mesh.positions[3 * v] - n);
  return mesh;
}

PolygonMesh sideBySide(PolygonMesh a, const PolygonMesh& b) {
  const auto first = static_cast<std::uint32_t>(a.vertexCount());
  a.positions.insert(a.positions.end(), b.positions.begin(), b.positions.end());
  std::vector<std::uint32_t> triangles = a.faceVertices;
  for (const std::uint32_t v : b.faceVertices) triangles.push_back(first + v);
  return makeTriangleMesh(a.positions, triangles);
}

}  // namespace

TEST_CASE("steps become the slope that they follow") {
  const PolygonMesh mesh = stairs(20);
  const Smoothed out = smoothed(mesh, 1);
  CHECK(out.triangles == mesh.faceCount());
  const double slope = 20 * 20 * std::sqrt(2);
  CHECK(totalArea(mesh, mesh.positions) > 1.4 * slope);
  CHECK(totalArea(mesh, out.positions) < 1.05 * slope);
}

TEST_CASE("no vertex moves beyond what is unseen") {
  const PolygonMesh mesh = bumpyGrid(30, 30, 1.5, 4);
  for (const double reach : {0.1, 0.4, 1.}) {
    const Smoothed out = smoothed(mesh, reach);
    CHECK(out.triangles == (reach > 0.2 ? mesh.faceCount() : 0));
    for (std::size_t v = 0; v < mesh.vertexCount(); ++v) {
      Vec3 move;
      for (std::size_t d = 0; d < 3; ++d)
        move[d] = out.positions[3 * v + d] - mesh.positions[3 * v + d];
      CHECK(norm(move) <= reach * (1 + 1e-12));
    }
  }
}

TEST_CASE("what is smooth or has creases stays exactly as it is") {
  for (const PolygonMesh& mesh : {torus(60, 30), roof(20), uvSphere(40, 20), tetrahedron()}) {
    const Smoothed out = smoothed(mesh, 0.02);
    CHECK(out.triangles == 0);
    CHECK(out.positions == mesh.positions);
  }
}

TEST_CASE("what is thin stays exactly as it is, although it loses area") {
  PolygonMesh mesh = torus(80, 24);
  for (std::size_t v = 0; v < mesh.vertexCount(); ++v) mesh.positions[3 * v + 2] *= 0.02;
  const Surface surface = buildSurface(mesh);
  for (const double reach : {0.02, 0.05, 0.1}) {
    const Smoothed out = smoothNoise(mesh, surface, reach);
    CHECK(out.triangles == 0);
    CHECK(out.positions == mesh.positions);
  }
}

TEST_CASE("a part that is small, would hardly be left or lies beside a noisy one stays") {
  CHECK(smoothed(stairs(10), 1).triangles == 0);
  CHECK(smoothed(torus(300, 3), 10).triangles == 0);
  const PolygonMesh noisy = stairs(20), calm = roof(20);
  const Smoothed out = smoothed(sideBySide(noisy, calm), 1);
  CHECK(out.triangles == noisy.faceCount());
  CHECK(std::equal(calm.positions.begin(), calm.positions.end(),
                   out.positions.begin() + static_cast<std::ptrdiff_t>(noisy.positions.size())));
}

TEST_CASE("a wall on a surface does not pull it") {
  const PolygonMesh mesh = stairs(20);
  std::vector<double> positions = mesh.positions;
  std::vector<std::uint32_t> triangles = mesh.faceVertices;
  // On the row of vertices in the middle, 41 in each row.
  for (std::uint32_t i = 0; i < 41; ++i) {
    const std::size_t foot = 3 * (10 * 41 + std::size_t{i});
    positions.insert(positions.end(),
                     {positions[foot] - 3, positions[foot + 1], positions[foot + 2] + 3});
  }
  for (std::uint32_t i = 0; i + 1 < 41; ++i) {
    const std::uint32_t a = 10 * 41 + i, tip = 21 * 41 + i;
    triangles.insert(triangles.end(), {a, a + 1, tip, tip, a + 1, tip + 1});
  }
  const Smoothed alone = smoothed(mesh, 1);
  const Smoothed walled = smoothed(makeTriangleMesh(positions, triangles), 1);
  // Far from its ends, where it meets the boundary.
  for (std::uint32_t row = 9; row < 12; ++row)
    for (std::size_t i = 3 * (41 * row + 18); i < 3 * (41 * row + 23); ++i)
      CHECK(walled.positions[i] == Approx(alone.positions[i]).margin(1e-12));
}

TEST_CASE("smoothing does not depend on how vertices and faces are numbered") {
  const PolygonMesh mesh = stairs(20);
  const Smoothed wanted = smoothed(mesh, 1);
  REQUIRE(wanted.triangles > 0);
  for (unsigned seed = 1; seed < 4; ++seed) {
    const Renumbered other = renumbered(mesh, seed);
    const Smoothed found = smoothed(other.mesh, 1);
    CHECK(found.triangles == wanted.triangles);
    for (std::size_t v = 0; v < mesh.vertexCount(); ++v)
      for (std::size_t d = 0; d < 3; ++d)
        CHECK(found.positions[3 * std::size_t{other.vertex[v]} + d] ==
              Approx(wanted.positions[3 * v + d]).margin(1e-12));
  }
}
