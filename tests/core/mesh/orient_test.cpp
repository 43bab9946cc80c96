#include "abflat/orient.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "abflat/inspect.h"
#include "catch.h"
#include "support/closed_meshes.h"
#include "support/meshes.h"

using namespace abflat;
using namespace abflat::test;

namespace {

double volume(const PolygonMesh& mesh) {
  double sum = 0;
  for (std::size_t f = 0; f < mesh.faceCount(); ++f)
    for (std::uint32_t c = mesh.faceOffsets[f] + 2; c < mesh.faceOffsets[f + 1]; ++c) {
      const auto at = [&](std::uint32_t corner) {
        return &mesh.positions[3 * std::size_t{mesh.faceVertices[corner]}];
      };
      const double *p = at(mesh.faceOffsets[f]), *q = at(c - 1), *r = at(c);
      sum += p[0] * (q[1] * r[2] - q[2] * r[1]) + p[1] * (q[2] * r[0] - q[0] * r[2]) +
             p[2] * (q[0] * r[1] - q[1] * r[0]);
    }
  return sum / 6;
}

/// Turns each face with this probability; returns the faces.
std::vector<std::uint32_t> turnAtRandom(PolygonMesh& mesh, double share, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<std::uint32_t> faces;
  for (std::uint32_t f = 0; f < mesh.faceCount(); ++f)
    if (static_cast<double>(random()) < share * 4294967296.0) faces.push_back(f);
  turnFaces(faces, mesh);
  return faces;
}

PolygonMesh joined(const PolygonMesh& a, const PolygonMesh& b) {
  PolygonMesh out = a;
  out.positions.insert(out.positions.end(), b.positions.begin(), b.positions.end());
  for (const std::uint32_t v : b.faceVertices)
    out.faceVertices.push_back(v + static_cast<std::uint32_t>(a.vertexCount()));
  for (std::size_t f = 1; f <= b.faceCount(); ++f)
    out.faceOffsets.push_back(b.faceOffsets[f] + a.faceOffsets.back());
  return out;
}

}  // namespace

TEST_CASE("turning: faces of closed parts run alike, seen from outside", "[orient]") {
  for (const PolygonMesh& mesh :
       {torus(12, 8), tetrahedron(), uvSphere(12, 8), exploded(torus(9, 7))})
    for (const double share : {0.1, 0.5, 0.9})
      for (unsigned seed = 0; seed < 5; ++seed)
        for (const double scale : {1e-200, 1.0, 1e200}) {
          const PolygonMesh straight = transformed(mesh, 1, {3, -20, 7});
          PolygonMesh mixed = renumbered(straight, seed).mesh;
          turnAtRandom(mixed, share, seed);
          PolygonMesh scaled = mixed;
          for (double& x : scaled.positions) x *= scale;
          const std::vector<std::uint32_t> faces = facesToTurn(scaled);
          CHECK(std::is_sorted(faces.begin(), faces.end()));
          // If all or none were turned, they run alike and stay.
          if (faces.empty()) continue;
          turnFaces(faces, mixed);
          CHECK(facesToTurn(mixed).empty());
          CHECK(volume(mixed) == Approx(std::abs(volume(straight))));
        }
}

TEST_CASE("turning: open parts keep what most of their area does", "[orient]") {
  for (unsigned seed = 0; seed < 10; ++seed) {
    PolygonMesh mesh = bumpyGrid(9, 7, 0.3, seed);
    const std::vector<std::uint32_t> turned = turnAtRandom(mesh, 0.15, seed);
    CHECK(facesToTurn(mesh) == turned);
  }
}

TEST_CASE("turning: an open part without a clear majority faces outwards", "[orient]") {
  // A cap is seen from outside as the sphere it belongs to is.
  PolygonMesh cap = cone(24, 1);
  for (unsigned seed = 0; seed < 10; ++seed) {
    PolygonMesh mixed = cap;
    std::vector<std::uint32_t> half;
    for (std::uint32_t f = 0; f < 24; ++f)
      if ((7 * f + seed) % 24 < 12) half.push_back(f);
    turnFaces(half, mixed);
    turnFaces(facesToTurn(mixed), mixed);
    CHECK(mixed.faceVertices == cap.faceVertices);
  }
}

TEST_CASE("turning: parts that run alike stay, however they are seen", "[orient]") {
  PolygonMesh room = torus(8, 6);
  std::vector<std::uint32_t> all(room.faceCount());
  for (std::uint32_t f = 0; f < all.size(); ++f) all[f] = f;
  turnFaces(all, room);
  CHECK(facesToTurn(room).empty());
  // Beside another part that does not.
  PolygonMesh mixed = tetrahedron();
  for (double& x : mixed.positions) x += 9;
  turnFaces({2}, mixed);
  const std::vector<std::uint32_t> faces = facesToTurn(joined(room, mixed));
  CHECK(faces == std::vector<std::uint32_t>{static_cast<std::uint32_t>(room.faceCount()) + 2});
}

TEST_CASE("turning: a surface with one side keeps an edge between opposite faces", "[orient]") {
  constexpr std::uint32_t kQuads = 9;
  PolygonMesh strip;
  strip.faceOffsets = {0};
  for (std::uint32_t i = 0; i < kQuads; ++i) {
    const double a = 6.283185307179586 * i / kQuads, x = std::cos(a), y = std::sin(a);
    const double w = 0.3 * std::cos(a / 2), h = 0.3 * std::sin(a / 2);
    strip.positions.insert(strip.positions.end(),
                           {x * (1 - w), y * (1 - w), -h, x * (1 + w), y * (1 + w), h});
    const std::uint32_t p = 2 * i, q = i + 1 < kQuads ? p + 2 : 1, r = i + 1 < kQuads ? p + 3 : 0;
    strip.faceVertices.insert(strip.faceVertices.end(), {p, p + 1, r, q});
    strip.faceOffsets.push_back(4 * (i + 1));
  }
  for (unsigned seed = 0; seed < 10; ++seed) {
    PolygonMesh mixed = strip;
    turnAtRandom(mixed, 0.5, seed);
    turnFaces(facesToTurn(mixed), mixed);
    CHECK(inspect(mixed).orientationConflicts == 1);
  }
}

TEST_CASE("turning: corners go with their texcoords, and twice is not at all", "[orient]") {
  PolygonMesh mesh = star(5);
  mesh.faceTexcoords = mesh.faceNormals = mesh.faceVertices;
  const PolygonMesh before = mesh;
  const std::vector<std::uint32_t> order = turnedCorners(mesh, {0});
  CHECK(order.front() == 0);
  turnFaces({0}, mesh);
  CHECK(mesh.faceVertices == reordered(before.faceVertices, order));
  CHECK(mesh.faceTexcoords == mesh.faceVertices);
  CHECK(mesh.faceNormals == mesh.faceVertices);
  CHECK(mesh.faceVertices != before.faceVertices);
  turnFaces({0}, mesh);
  CHECK(mesh.faceVertices == before.faceVertices);
}

TEST_CASE("turning: can be stopped", "[orient]") {
  PolygonMesh mesh = torus(200, 200);
  turnAtRandom(mesh, 0.5, 1);
  CHECK(facesToTurn(mesh, [] { return false; }).empty());
}
