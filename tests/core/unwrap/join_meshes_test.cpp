#include "abflat/join_meshes.h"

#include <array>
#include <cmath>
#include <map>
#include <set>

#include "abflat/orient.h"
#include "catch.h"
#include "seam/hard_edges.h"
#include "support/meshes.h"
#include "support/unwrapped.h"

using namespace abflat;
using namespace abflat::test;

namespace {

/// The marked edges of a mesh, by its vertices; of joined meshes, all of them.
std::set<std::array<std::uint32_t, 2>> hardEdgesOf(const PolygonMesh& mesh) {
  const WeldedMesh welded = weld(mesh);
  const Surface surface = buildSurface(welded.mesh);
  const SurfaceMap map{mesh, welded, surface};
  std::set<std::array<std::uint32_t, 2>> out;
  const Seams hard = hardEdges(map);
  for (const SurfaceCorner h : hard.ids())
    if (hard[h]) out.insert({map.vertex(h), map.vertex(nextCorner(h))});
  return out;
}

PolygonMesh withNormals(PolygonMesh mesh) {
  mesh.normals = mesh.positions;
  mesh.faceNormals = mesh.faceVertices;
  for (std::size_t c = 0; c < mesh.faceNormals.size(); c += 5) mesh.faceNormals[c] = kNoNormal;
  return mesh;
}

PolygonMesh withGroups(PolygonMesh mesh) {
  for (std::uint32_t f = 0; f < mesh.faceCount(); ++f) mesh.faceSmoothing.push_back(f % 3);
  return mesh;
}

PolygonMesh withTexcoords(PolygonMesh mesh) {
  for (std::size_t v = 0; v < mesh.vertexCount(); ++v)
    mesh.texcoords.insert(mesh.texcoords.end(), {mesh.positions[3 * v], mesh.positions[3 * v + 1]});
  mesh.faceTexcoords = mesh.faceVertices;
  mesh.faceTexcoords.back() = kNoTexcoord;
  return mesh;
}

PolygonMesh withMaterials(PolygonMesh mesh) {
  mesh.materialNames = {"steel", "wood"};
  for (std::uint32_t f = 0; f < mesh.faceCount(); ++f) mesh.faceMaterials.push_back(f % 2);
  return mesh;
}

PolygonMesh joinedOf(const std::vector<const PolygonMesh*>& meshes) {
  Result<PolygonMesh> out = joinMeshes(meshes);
  INFO(out.status().message);
  REQUIRE(out.ok());
  REQUIRE(validateArrays(out.value()).ok());
  return std::move(out.value());
}

/// What a corner has of some attribute; nothing if it has none.
std::vector<double> valueAt(const std::vector<double>& values, std::size_t width,
                            const std::vector<std::uint32_t>& ofCorner, std::size_t corner) {
  if (ofCorner.empty() || ofCorner[corner] == kNoNormal) return {};
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(width * ofCorner[corner]);
  return {at, at + static_cast<std::ptrdiff_t>(width)};
}

}  // namespace

TEST_CASE("joined meshes have at each corner what they had alone", "[join]") {
  const std::vector<PolygonMesh> meshes = {
      withNormals(uvSphere(12, 8)), withTexcoords(withGroups(torus(7, 5))), star(5),
      withMaterials(withTexcoords(bumpyGrid(4, 3, .5, 1))), PolygonMesh()};
  std::vector<const PolygonMesh*> parts;
  for (const PolygonMesh& mesh : meshes) parts.push_back(&mesh);
  const PolygonMesh joined = joinedOf(parts);
  std::size_t face = 0, corner = 0, vertex = 0;
  std::set<std::uint32_t> materials, objects;
  for (const PolygonMesh& mesh : meshes) {
    std::map<std::uint32_t, std::uint32_t> material;
    for (std::size_t f = 0; f < mesh.faceCount(); ++f, ++face) {
      REQUIRE(joined.faceOffsets[face] == corner);
      const std::uint32_t alone = mesh.faceMaterials.empty() ? 0 : mesh.faceMaterials[f];
      const auto [known, isNew] = material.try_emplace(alone, joined.faceMaterials[face]);
      REQUIRE(known->second == joined.faceMaterials[face]);
      if (isNew) REQUIRE(materials.insert(known->second).second);
      if (!mesh.materialNames.empty())
        REQUIRE(joined.materialNames[known->second] == mesh.materialNames[alone]);
      for (std::size_t c = mesh.faceOffsets[f]; c < mesh.faceOffsets[f + 1]; ++c, ++corner) {
        REQUIRE(joined.faceVertices[corner] == vertex + mesh.faceVertices[c]);
        REQUIRE(valueAt(joined.positions, 3, joined.faceVertices, corner) ==
                valueAt(mesh.positions, 3, mesh.faceVertices, c));
        REQUIRE(valueAt(joined.normals, 3, joined.faceNormals, corner) ==
                valueAt(mesh.normals, 3, mesh.faceNormals, c));
        REQUIRE(valueAt(joined.texcoords, 2, joined.faceTexcoords, corner) ==
                valueAt(mesh.texcoords, 2, mesh.faceTexcoords, c));
      }
    }
    vertex += mesh.vertexCount();
    if (vertex > 0) objects.insert(joined.vertexObjects[vertex - 1]);
  }
  CHECK(joined.faceCount() == face);
  CHECK(joined.vertexCount() == vertex);
  CHECK(objects.size() == 4);
}

TEST_CASE("joined meshes have the hard edges that they had alone", "[join]") {
  const std::vector<PolygonMesh> meshes = {withNormals(uvSphere(12, 8)), withGroups(torus(7, 5)),
                                           bumpyGrid(4, 3, .5, 1), uvSphere(6, 5)};
  for (const std::vector<std::size_t>& order :
       {std::vector<std::size_t>{0, 1, 2, 3}, {3, 1}, {2, 0}, {1, 0, 1}, {2, 3}}) {
    std::vector<const PolygonMesh*> parts;
    std::set<std::array<std::uint32_t, 2>> expected;
    std::uint32_t base = 0;
    for (const std::size_t i : order) {
      for (const auto& [a, b] : hardEdgesOf(meshes[i])) expected.insert({a + base, b + base});
      base += static_cast<std::uint32_t>(meshes[i].vertexCount());
      parts.push_back(&meshes[i]);
    }
    CHECK(hardEdgesOf(joinedOf(parts)) == expected);
  }
}

TEST_CASE("each joined mesh gets its part of the layout, and nothing is welded across", "[join]") {
  PolygonMesh turned = torus(9, 7);
  turnFaces({3, 4, 20}, turned);
  const PolygonMesh sphere = uvSphere(10, 8);
  const std::vector<const PolygonMesh*> parts = {&sphere, &sphere, &turned, &sphere};
  const PolygonMesh joined = joinedOf(parts);
  UnwrapOptions options;
  options.resolution = 256;
  options.orient = true;
  const UnwrapResult whole = unwrapped(joined, options);
  const std::vector<JoinedPart> layouts = splitLayout(whole, parts);
  REQUIRE(layouts.size() == parts.size());
  std::size_t corner = 0, face = 0, triangles = 0, base = 0;
  std::set<std::uint32_t> chartsBefore;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const JoinedPart& layout = layouts[i];
    REQUIRE(layout.cornerUv.size() == parts[i]->faceVertices.size());
    std::set<std::uint32_t> used(layout.cornerUv.begin(), layout.cornerUv.end());
    CHECK(used.size() == layout.uv.size() / 2);
    for (std::size_t c = 0; c < layout.cornerUv.size(); ++c, ++corner)
      REQUIRE(valueAt(layout.uv, 2, layout.cornerUv, c) ==
              valueAt(whole.uv, 2, whole.cornerUv, corner));
    for (const std::uint32_t c : layout.triangleCorners)
      REQUIRE(c + base == whole.triangleCorners[triangles++]);
    std::set<std::uint32_t> charts;
    for (const std::uint32_t chart : layout.chartOfFace) {
      REQUIRE(chart == whole.chartOfFace[face++]);
      REQUIRE(chartsBefore.count(chart) == 0);
      charts.insert(chart);
    }
    chartsBefore.insert(charts.begin(), charts.end());
    base = corner;
  }
  CHECK(triangles == whole.triangleCorners.size());
  CHECK(layouts[2].turnedFaces == std::vector<std::uint32_t>{3, 4, 20});
  CHECK(layouts[3].turnedFaces.empty());
}

TEST_CASE("a layout turns the faces of its mesh with their texcoords", "[join]") {
  const PolygonMesh straight = torus(9, 7);
  PolygonMesh mesh = straight;
  turnFaces({3, 4, 20}, mesh);
  const PolygonMesh other = tetrahedron();
  const PolygonMesh joined = joinedOf({&other, &mesh});
  UnwrapOptions options;
  options.resolution = 256;
  options.orient = true;
  const UnwrapResult whole = unwrapped(joined, options);
  JoinedPart layout = splitLayout(whole, {&other, &mesh})[1];
  const JoinedPart before = layout;
  const PolygonMesh was = mesh;
  turnFaces(mesh, layout);
  CHECK(mesh.faceVertices == straight.faceVertices);
  // A vertex of a face keeps its texcoord.
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    std::map<std::uint32_t, std::uint32_t> texcoord;
    for (std::size_t c = mesh.faceOffsets[f]; c < mesh.faceOffsets[f + 1]; ++c)
      texcoord[was.faceVertices[c]] = before.cornerUv[c];
    for (std::size_t c = mesh.faceOffsets[f]; c < mesh.faceOffsets[f + 1]; ++c)
      REQUIRE(texcoord.at(mesh.faceVertices[c]) == layout.cornerUv[c]);
  }
  // Triangles have the vertices that they had.
  for (std::size_t i = 0; i < layout.triangleCorners.size(); ++i)
    REQUIRE(mesh.faceVertices[layout.triangleCorners[i]] ==
            was.faceVertices[before.triangleCorners[i]]);
}

TEST_CASE("where only some meshes have z up, y is up in all", "[join]") {
  PolygonMesh z = transformed(tetrahedron(), 2, {1, 2, 3});
  z.isZUp = true;
  const PolygonMesh y = tetrahedron();
  CHECK(joinedOf({&z, &z}).isZUp);
  const PolygonMesh joined = joinedOf({&y, &z});
  CHECK(!joined.isZUp);
  for (std::size_t v = 0; v < z.vertexCount(); ++v) {
    const std::size_t i = 3 * v, j = 3 * (v + y.vertexCount());
    CHECK(joined.positions[j] == z.positions[i]);
    CHECK(joined.positions[j + 1] == z.positions[i + 2]);
    CHECK(joined.positions[j + 2] == -z.positions[i + 1]);
  }
}

TEST_CASE("an index beyond a mesh is not one of the next", "[join]") {
  const PolygonMesh good = tetrahedron();
  PolygonMesh bad = tetrahedron();
  bad.faceVertices[4] = 4;
  const Status status = joinMeshes({&good, &bad, &good}).status();
  CHECK(status.code == StatusCode::InvalidMesh);
  CHECK(status.message.find("mesh 1: ") == 0);
  CHECK(joinMeshes({}).value().faceCount() == 0);
}
