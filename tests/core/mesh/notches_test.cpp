#include "mesh/notches.h"

#include <cmath>

#include "catch.h"
#include "support/meshes.h"

using namespace abflat;
using namespace abflat::test;

namespace {

constexpr double kPi = 3.14159265358979323846;

/// A sphere as parametrised: columns + 1 vertices a row, also at the poles, one triangle for each
/// column there.
PolygonMesh parametrisedSphere(std::uint32_t columns, std::uint32_t rows) {
  PolygonMesh mesh;
  mesh.faceOffsets.push_back(0);
  for (std::uint32_t i = 0; i <= rows; ++i)
    for (std::uint32_t k = 0; k <= columns; ++k) {
      const double theta = kPi * i / rows, phi = 2 * kPi * (k % columns) / columns;
      for (const double x :
           {std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi)})
        mesh.positions.push_back(x);
    }
  const auto add = [&](std::initializer_list<std::uint32_t> face) {
    mesh.faceVertices.insert(mesh.faceVertices.end(), face);
    mesh.faceOffsets.push_back(static_cast<std::uint32_t>(mesh.faceVertices.size()));
  };
  for (std::uint32_t i = 0; i < rows; ++i)
    for (std::uint32_t k = 0; k < columns; ++k) {
      const std::uint32_t a = i * (columns + 1) + k, b = a + columns + 1;
      if (i > 0) add({a, a + 1, b + 1});
      if (i + 1 < rows) add({a, b + 1, b});
    }
  return mesh;
}

WeldedMesh closed(const PolygonMesh& mesh) {
  return weld(mesh, false, {}, findNotches(mesh, buildSurface(mesh)));
}

/// The same, joined along its meridian, with a hole in place of one pole.
PolygonMesh joinedCap(std::uint32_t columns, std::uint32_t rows) {
  PolygonMesh mesh = parametrisedSphere(columns, rows);
  mesh.faceOffsets.resize(mesh.faceCount() - columns + 1);
  mesh.faceVertices.resize(mesh.faceOffsets.back());
  const std::uint32_t size = columns + 1;
  for (std::uint32_t& v : mesh.faceVertices)
    if (v >= size && v % size == columns) v -= columns;
  return mesh;
}

}  // namespace

TEST_CASE("poles with a vertex for each face are one vertex") {
  for (const auto& [columns, rows] : {std::pair{3u, 3u}, {12u, 7u}, {71u, 70u}}) {
    const PolygonMesh mesh = parametrisedSphere(columns, rows);
    REQUIRE(inspect(mesh).disk.ok());
    const WeldedMesh out = closed(mesh);
    CHECK(out.mergedVertices == 2 * (columns - 1));
    CHECK(inspect(out.mesh).disk.ok());
    // The meridian that the numbers leave open stays open.
    CHECK(buildSurface(out.mesh).boundaryLoops.front().size() == 2 * rows);
  }
}

TEST_CASE("a loop of nothing but notches stays open") {
  const PolygonMesh cap = joinedCap(8, 5);
  REQUIRE(inspect(cap).boundaryLoops == 2);
  CHECK(findNotches(cap, buildSurface(cap)).empty());
}

TEST_CASE("longer slits and those with a width stay") {
  // Two rows of squares, parted along 0 to 2 edges from the left.
  for (const std::uint32_t slit : {0u, 1u, 2u})
    for (const double width : {0.0, 1e-3}) {
      PolygonMesh mesh = bumpyGrid(4, 2, 0.3, 1);
      const auto middle = [](std::uint32_t k) { return 5 + k; };
      const auto copies = static_cast<std::uint32_t>(mesh.vertexCount());
      for (std::uint32_t k = 0; k < slit; ++k) {
        for (std::size_t d = 0; d < 3; ++d)
          mesh.positions.push_back(double{mesh.positions[3 * middle(k) + d]});
        mesh.positions[3 * (copies + k) + 2] += width;
      }
      for (std::uint32_t f = 0; f < mesh.faceCount(); ++f) {
        const std::uint32_t begin = mesh.faceOffsets[f], end = mesh.faceOffsets[f + 1];
        bool isUpper = false;
        for (std::uint32_t c = begin; c < end; ++c) isUpper |= mesh.faceVertices[c] > middle(4);
        for (std::uint32_t c = begin; c < end && isUpper; ++c)
          for (std::uint32_t k = 0; k < slit; ++k)
            if (mesh.faceVertices[c] == middle(k)) mesh.faceVertices[c] = copies + k;
      }
      REQUIRE(inspect(mesh).disk.ok());
      CHECK(findNotches(mesh, buildSurface(mesh)).size() == (slit == 1 && width == 0 ? 1u : 0u));
    }
}
