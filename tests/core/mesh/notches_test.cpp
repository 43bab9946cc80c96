#include "mesh/notches.h"

#include "catch.h"
#include "support/meshes.h"

using namespace abflat;
using namespace abflat::test;

namespace {

WeldedMesh closed(const PolygonMesh& mesh) {
  return weld(mesh, false, {}, findNotches(mesh, buildSurface(mesh)));
}

/// The same sphere joined along its meridian, with a hole in place of one pole.
PolygonMesh joinedCap(std::uint32_t columns, std::uint32_t rows) {
  PolygonMesh mesh = uvSphere(columns, rows);
  mesh.faceOffsets.resize(mesh.faceCount() - columns + 1);
  mesh.faceVertices.resize(mesh.faceOffsets.back());
  const std::uint32_t size = columns + 1;
  for (std::uint32_t& v : mesh.faceVertices)
    if (v >= size && v % size == columns) v -= columns;
  return mesh;
}

}  // namespace

TEST_CASE("poles with a vertex for each face are one vertex") {
  for (const auto& [columns, rows] : {std::pair{8u, 6u}, {12u, 7u}, {71u, 70u}}) {
    const PolygonMesh mesh = uvSphere(columns, rows);
    REQUIRE(inspect(mesh).disk.ok());
    const WeldedMesh out = closed(mesh);
    CHECK(out.mergedVertices == 2 * (columns - 1));
    CHECK(inspect(out.mesh).disk.ok());
    // The meridian, whose sides have different vertex numbers, stays open.
    CHECK(buildSurface(out.mesh).boundaryLoops.front().size() == 2 * rows);
  }
}

TEST_CASE("a loop of nothing but notches stays open") {
  const PolygonMesh cap = joinedCap(8, 5);
  REQUIRE(inspect(cap).boundaryLoops == 2);
  CHECK(findNotches(cap, buildSurface(cap)).empty());
}

TEST_CASE("longer slits and those with a width stay") {
  // Two rows of squares, separated along 0 to 2 edges from the left.
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

TEST_CASE("slits that let a corner lie flat stay") {
  const PolygonMesh coarse = uvSphere(4, 3);
  REQUIRE(inspect(coarse).disk.ok());
  CHECK(findNotches(coarse, buildSurface(coarse)).empty());
}
