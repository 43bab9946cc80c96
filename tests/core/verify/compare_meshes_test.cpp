#include "abflat/compare_meshes.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <random>
#include <vector>

#include "abflat/orient.h"
#include "abflat/samples.h"
#include "catch.h"

using namespace abflat;

namespace {

PolygonMesh roundMesh() { return samples().front().make(1); }

/// A pyramid on a base of five sides.
PolygonMesh pyramid() {
  PolygonMesh out;
  out.positions = {0, 0, 0, 2, 0, 0, 3, 2, 0, 1, 3, 0, -1, 2, 0, 1, 1, 2};
  out.faceOffsets = {0, 5, 8, 11, 14, 17, 20};
  out.faceVertices = {4, 3, 2, 1, 0, 0, 1, 5, 1, 2, 5, 2, 3, 5, 3, 4, 5, 4, 0, 5};
  return out;
}

std::vector<MeshDifference> differences(const PolygonMesh& was, const PolygonMesh& now,
                                        const CompareMeshesOptions& options = {}) {
  const auto found = compareMeshes({was, {}}, {now, {}}, options);
  REQUIRE(found.ok());
  return found.value();
}

/// The same faces of vertices in another order, with a copy of each vertex for each of its faces.
PolygonMesh withOwnVertices(const PolygonMesh& mesh) {
  PolygonMesh out = mesh;
  out.positions.clear();
  for (const std::uint32_t v : mesh.faceVertices)
    out.positions.insert(out.positions.end(), &mesh.positions[3 * std::size_t{v}],
                         &mesh.positions[3 * std::size_t{v}] + 3);
  std::iota(out.faceVertices.begin(), out.faceVertices.end(), 0u);
  return out;
}

PolygonMesh shuffled(const PolygonMesh& mesh, unsigned seed) {
  std::vector<std::uint32_t> order(mesh.faceCount());
  std::iota(order.begin(), order.end(), 0u);
  std::shuffle(order.begin(), order.end(), std::mt19937(seed));
  PolygonMesh out = mesh;
  out.faceOffsets = {0};
  out.faceVertices.clear();
  for (const std::uint32_t f : order) {
    out.faceVertices.insert(
        out.faceVertices.end(), &mesh.faceVertices[mesh.faceOffsets[f]],
        &mesh.faceVertices[mesh.faceOffsets[f]] + (mesh.faceOffsets[f + 1] - mesh.faceOffsets[f]));
    out.faceOffsets.push_back(static_cast<std::uint32_t>(out.faceVertices.size()));
  }
  return out;
}

CornerAttribute perVertex(const PolygonMesh& mesh) {
  CornerAttribute out{"weights", 1, {}, mesh.faceVertices, 0};
  for (std::size_t v = 0; v < mesh.vertexCount(); ++v) out.values.push_back(static_cast<double>(v));
  return out;
}

}  // namespace

TEST_CASE("a mesh is the same with copies of vertices and in single precision", "[verify]") {
  for (const PolygonMesh& mesh : {roundMesh(), pyramid()}) {
    CHECK(differences(mesh, mesh).empty());
    PolygonMesh rounded = mesh;
    for (double& x : rounded.positions) x = static_cast<float>(x);
    CHECK(differences(mesh, rounded).empty());
    CHECK(differences(mesh, withOwnVertices(mesh), {true, false}).empty());
    CHECK(differences(withOwnVertices(mesh), mesh, {true, false}).empty());
  }
}

TEST_CASE("polygons may become triangles", "[verify]") {
  const PolygonMesh mesh = pyramid();
  PolygonMesh triangles = mesh;
  triangles.faceVertices = {4, 3, 2, 4, 2, 1, 4, 1, 0, 0, 1, 5, 1, 2, 5, 2, 3, 5, 3, 4, 5, 4, 0, 5};
  triangles.faceOffsets = {0, 3, 6, 9, 12, 15, 18, 21, 24};
  CHECK(differences(mesh, triangles).empty());
  triangles.faceVertices[3] = 5;  // the tip, which the base has not
  CHECK_FALSE(differences(mesh, triangles).empty());
  triangles.faceVertices[3] = 4;
  triangles.faceVertices.resize(21);
  triangles.faceOffsets.pop_back();
  CHECK(differences(mesh, triangles).size() == 1);
}

TEST_CASE("faces that are missing, new, turned, or elsewhere in the order are told", "[verify]") {
  for (const PolygonMesh& mesh : {roundMesh(), pyramid()}) {
    PolygonMesh turned = mesh;
    turnFaces({2, 3}, turned);
    auto found = differences(mesh, turned);
    REQUIRE(found.size() == 1);
    CHECK(found[0].kind == MeshDifferenceKind::Geometry);
    CHECK(found[0].faces == std::vector<std::uint32_t>{2, 3});
    found = differences(mesh, shuffled(mesh, 7));
    REQUIRE(found.size() == 1);
    CHECK(found[0].kind == MeshDifferenceKind::Order);
    CHECK(differences(mesh, shuffled(withOwnVertices(mesh), 7), {false, false}).empty());
    PolygonMesh moved = mesh;
    moved.positions[3 * std::size_t{mesh.faceVertices.back()}] += 0.01;
    const auto around = static_cast<std::size_t>(
        std::count(mesh.faceVertices.begin(), mesh.faceVertices.end(), mesh.faceVertices.back()));
    found = differences(mesh, moved, {true, false});
    REQUIRE(found.size() == 2);
    CHECK(found[1].faces.size() == around);
    CHECK(differences(mesh, moved).size() == 3);
  }
}

TEST_CASE("attributes follow their corners", "[verify]") {
  const PolygonMesh mesh = roundMesh();
  const PolygonMesh apart = withOwnVertices(mesh);
  const std::vector<CornerAttribute> was = {perVertex(mesh)};
  std::vector<CornerAttribute> now = was;
  now[0].values.clear();
  for (std::size_t c = 0; c < mesh.faceVertices.size(); ++c) {
    now[0].values.push_back(mesh.faceVertices[c]);
    now[0].row[c] = static_cast<std::uint32_t>(c);
  }
  const auto compare = [&] {
    const auto found = compareMeshes({mesh, was}, {apart, now}, {true, false});
    REQUIRE(found.ok());
    return found.value();
  };
  CHECK(compare().empty());
  now[0].values[4] += 0.5;
  auto found = compare();
  REQUIRE(found.size() == 1);
  CHECK(found[0].kind == MeshDifferenceKind::Attribute);
  CHECK(found[0].faces == std::vector<std::uint32_t>{1});
  now[0].tolerance = 0.5;
  CHECK(compare().empty());
  now[0].row[7] = kNoRow;
  found = compare();
  REQUIRE(found.size() == 1);
  CHECK(found[0].faces == std::vector<std::uint32_t>{2});
  now.clear();
  CHECK(compare().size() == 1);
}
