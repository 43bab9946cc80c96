#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>

#include <array>

#include "abflat/gltf.h"
#include "catch.h"
#include "gltf_files.h"
#include "support/little_memory.h"

namespace abflat {
namespace {

using test::checkWithLittleMemory;
using test::ended;

/// Two triangles, compressed by Draco.
std::string dracoGlb() {
  draco::TriangleSoupMeshBuilder builder;
  builder.Start(2);
  const int positions =
      builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
  using Point = std::array<float, 3>;
  const Point a = {0, 0, 0}, b = {1, 0, 0}, c = {1, 1, 0}, d = {0, 1, 0};
  builder.SetAttributeValuesForFace(positions, draco::FaceIndex(0), a.data(), b.data(), c.data());
  builder.SetAttributeValuesForFace(positions, draco::FaceIndex(1), a.data(), c.data(), d.data());
  const std::unique_ptr<draco::Mesh> mesh = builder.Finalize();
  draco::Encoder encoder;
  draco::EncoderBuffer packed;
  REQUIRE(encoder.EncodeMeshToBuffer(*mesh, &packed).ok());
  return test::glbOf(R"({
    "asset": {"version": "2.0"}, "buffers": [{"byteLength": {SIZE}}],
    "extensionsUsed": ["KHR_draco_mesh_compression"],
    "extensionsRequired": ["KHR_draco_mesh_compression"],
    "bufferViews": [{"buffer": 0, "byteLength": )" +
                         std::to_string(packed.size()) + R"(}],
    "accessors": [
      {"componentType": 5126, "count": 4, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]},
      {"componentType": 5123, "count": 6, "type": "SCALAR"}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1,
      "extensions": {"KHR_draco_mesh_compression":
                     {"bufferView": 0, "attributes": {"POSITION": 0}}}}]}]})",
                     std::string(packed.data(), packed.size()));
}

/// Each corner has a texcoord of its own, so that vertices are copied.
struct OwnTexcoords {
  std::vector<double> uv;
  std::vector<std::uint32_t> cornerUv;
};

OwnTexcoords ownTexcoords(const PolygonMesh& mesh) {
  OwnTexcoords out;
  for (std::uint32_t c = 0; c < mesh.faceVertices.size(); ++c) {
    out.uv.insert(out.uv.end(), {0.25 * (c % 3), 0.125 * (c % 7)});
    out.cornerUv.push_back(c);
  }
  return out;
}

constexpr const char* kObj = R"(mtllib a.mtl
o quad
v 0 0 0 1 0 0
v 1 0 0 0 1 0
v 1 1 0 0 0 1
v 0 1 0 1 1 1
vt 0 0
vn 0 0 1
usemtl red
f 1/1/1 2/1/1 3/1/1
usemtl blue
f 1/1 3/1 4/1
)";

Result<std::string> besideObj(const std::string& path) {
  if (path == "a.mtl")
    return std::string(
        "newmtl red\nKd 1 0 0\nmap_Kd textures/a picture with a long name.png\n"
        "newmtl blue\nKd 0 0 1\nd 0.5\n");
  return std::string("\x89PNG\r\n\x1a\n, and then the rest of a picture");
}

}  // namespace

TEST_CASE("reading and writing glTF report lack of memory, leak nothing and work again", "[gltf]") {
  for (const std::string& file : {test::octahedronGlb(), dracoGlb(), std::string("{\"asset\":[")})
    checkWithLittleMemory([&] {
      const Result<GltfModel> model = test::readAlone(file);
      return model.ok() ? ended({}, model.value().mesh.positions) : ended(model.status(), "");
    });
  const Result<GltfModel> model = test::readAlone(test::octahedronGlb());
  REQUIRE(model.ok());
  const OwnTexcoords own = ownTexcoords(model.value().mesh);
  for (const bool isBinary : {true, false}) {
    GltfWriteOptions options;
    options.isBinary = isBinary;
    checkWithLittleMemory(
        [&] { return ended(writeGltf(*model.value().source, own.uv, own.cornerUv, options)); });
  }
}

TEST_CASE("reading a look and making glTF of it report lack of memory", "[gltf][appearance]") {
  const Result<PolygonMesh> mesh = readMesh(kObj, MeshFormat::Obj, "a.obj");
  REQUIRE(mesh.ok());
  checkWithLittleMemory([&] {
    return ended(readAppearance(kObj, MeshFormat::Obj, mesh.value(), besideObj),
                 &Appearance::colors);
  });
  const Result<Appearance> look = readAppearance(kObj, MeshFormat::Obj, mesh.value(), besideObj);
  REQUIRE(look.value().images.size() == 1);
  const OwnTexcoords own = ownTexcoords(mesh.value());
  const std::vector<std::uint32_t> triangles = triangleCornersOf(mesh.value());
  for (const bool isBinary : {true, false})
    checkWithLittleMemory([&] {
      return ended(
          makeGltf(mesh.value(), own.uv, own.cornerUv, triangles, look.value(), {isBinary, 0}));
    });
}

}  // namespace abflat
