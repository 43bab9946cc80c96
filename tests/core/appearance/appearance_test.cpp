#include "abflat/appearance.h"

#include <cmath>

#include "appearance/mtl.h"
#include "catch.h"

namespace abflat {
namespace {

MtlMaterial materialOf(const std::string& lines) {
  MtlMaterials found;
  readMtl("newmtl a b\n" + lines, found);
  REQUIRE(found.size() == 1);
  REQUIRE(found.begin()->first == "a b");
  return found.begin()->second;
}

Appearance lookOf(const std::string& text, MeshFormat format, const ReadResource& readResource) {
  const Result<PolygonMesh> mesh = readMesh(text, format, "mesh");
  return mesh.ok() ? readAppearance(text, format, mesh.value(), readResource).value()
                   : Appearance();
}

/// Whether every index refers to something that exists, and every value is in its range.
bool isSound(const Appearance& look, const PolygonMesh& mesh) {
  bool ok = look.faceNormals.empty() || look.faceNormals.size() == mesh.faceVertices.size();
  for (const std::uint32_t n : look.faceNormals) {
    ok = ok && 3 * std::size_t{n} + 2 < look.normals.size();
    double square = 0;
    for (std::size_t d = 0; ok && d < 3; ++d)
      square += look.normals[3 * std::size_t{n} + d] * look.normals[3 * std::size_t{n} + d];
    ok = ok && std::abs(square - 1) < 1e-12;
  }
  ok = ok && (look.colors.empty() || look.colors.size() == 4 * mesh.vertexCount());
  for (const double x : look.colors) ok = ok && x >= 0 && x <= 1;
  ok = ok && (look.faceObjects.empty() || look.faceObjects.size() == mesh.faceCount());
  for (const std::uint32_t o : look.faceObjects) ok = ok && o < look.objectNames.size();
  for (const MaterialLook& material : look.materials)
    ok = ok && (material.image == kNoImage || material.image < look.images.size());
  return ok;
}

TEST_CASE("the image of a material stands behind all options of its map", "[appearance]") {
  for (const std::string options :
       {"", "-s 1 ", "-o 0.5 0 0 -s 1 1 1 ", "-mm 0 1 -bm 0.3 ", "-clamp on -t 1 2 -texres 512 "})
    for (const std::string name : {"a.png", "my wood/the oak 2.png", "3.png", "..\\a-b.jpg"})
      CHECK(materialOf("map_Kd " + options + name + " \r\n").diffuseMap == name);
  CHECK(materialOf("map_Kd\n").diffuseMap.empty());
  CHECK(materialOf("map_Kd -s 1 1 1\n").diffuseMap.empty());
}

TEST_CASE("opacity counts before transparency, and a damaged value is none", "[appearance]") {
  CHECK(materialOf("d 0.25\nTr 0.5\n").opacity == 0.25);
  CHECK(materialOf("Tr 0.5\nd 0.25\n").opacity == 0.25);
  CHECK(materialOf("Tr 0.25\n").opacity == 0.75);
  CHECK(materialOf("d -halo 0.5\nd nan\n").opacity == 1);
  CHECK(materialOf("Kd 0.5\n").diffuse == std::array<double, 3>{0.5, 0.5, 0.5});
  CHECK(materialOf("Kd 0.5 0.25\nKd spectral a.rfl 1\n").diffuse == std::array<double, 3>{1, 1, 1});
  CHECK(materialOf("Kd -1 2 0.5\n").diffuse == std::array<double, 3>{0, 1, 0.5});
}

TEST_CASE("what is left of a file is read without harm", "[appearance]") {
  const std::string obj =
      "mtllib a.mtl\no x\nv 0 0 0 1 0 0\nv 1 0 0 0 1 300\nv 0 1 0\nv 0 0 1 1 1 1 1\nvn 0 0 1\n"
      "usemtl red\nf 1//1 2//-1 3//7\no y\nf 1//1 3//1 4//2\no x\nf 1 2 4\nvn 1e200 1 1\n";
  const std::string ply =
      "ply\nformat ascii 1.0\ncomment TextureFile a.png\nelement vertex 3\nproperty float x\n"
      "property float y\nproperty float z\nproperty float nx\nproperty float ny\n"
      "property float nz\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
      "0 0 0 0 0 1 255 0 x\n1 0 0 nan 0 1 1 2 3\n0 1 0 0 0 0 1 2 3\n3 0 1 2\n";
  const std::string mtl = "newmtl red\nKd 1 0 0\nmap_Kd a.png\n";
  const ReadResource files = [&](const std::string& path) -> Result<std::string> {
    if (path == "a.mtl") return mtl;
    return std::string("\xFF\xD8\xFF");
  };
  for (const auto& [text, format] :
       {std::pair(obj, MeshFormat::Obj), std::pair(ply, MeshFormat::Ply)}) {
    const Appearance whole = lookOf(text, format, files);
    CHECK(whole.images.size() == 1);
    CHECK_FALSE(whole.faceNormals.empty());
    std::size_t read = 0;
    for (std::size_t size = 0; size <= text.size(); ++size) {
      const std::string part = text.substr(0, size);
      const Result<PolygonMesh> mesh = readMesh(part, format, "mesh");
      if (!mesh.ok()) continue;
      ++read;
      CHECK(isSound(readAppearance(part, format, mesh.value(), files).value(), mesh.value()));
    }
    CHECK(read > 0);
  }
}

}  // namespace
}  // namespace abflat
