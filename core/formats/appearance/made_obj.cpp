#include "abflat/made_obj.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <set>

#include "appearance/color.h"
#include "io/text_writer.h"

namespace abflat {
namespace {

/// With as many digits as can be seen.
void putLine(TextWriter& out, const char* keyword, std::initializer_list<double> numbers) {
  out.put(keyword);
  for (const double number : numbers) {
    out.put(' ');
    out.put(std::round(1e6 * number) / 1e6);
  }
  out.put('\n');
}

void putColour(TextWriter& out, const char* keyword, const std::array<double, 3>& linear) {
  putLine(out, keyword,
          {srgbOfLinear(linear[0]), srgbOfLinear(linear[1]), srgbOfLinear(linear[2])});
}

void putMap(TextWriter& out, const char* keyword, const std::string& file) {
  if (file.empty()) return;
  out.put(keyword);
  out.put(' ');
  out.put(file);
  out.put('\n');
}

void putMaterial(TextWriter& out, const MadeMaterial& material) {
  out.put("newmtl ");
  out.put(material.name);
  out.put('\n');
  putColour(out, "Kd", material.colour);
  // What glTF takes for granted.
  out.put("Ks 0.5 0.5 0.5\nNi 1.5\nillum 2\n");
  putColour(out, "Ke", material.emission);
  putLine(out, "d", {material.opacity});
  putLine(out, "Pr", {material.roughness});
  putLine(out, "Pm", {material.metallic});
  putMap(out, "map_Kd", material.colourMap);
  putMap(out, "map_d", material.opacityMap);
  putMap(out, "map_Pr", material.roughnessMap);
  putMap(out, "map_Pm", material.metallicMap);
  putMap(out, "map_Ke", material.emissionMap);
  // Blender reads the one, programs with normal maps of their own the other.
  putMap(out, "map_Bump -bm 1", material.normalMap);
  putMap(out, "norm", material.normalMap);
}

void putRows(TextWriter& out, const char* keyword, const std::vector<double>& numbers,
             std::size_t width) {
  for (std::size_t i = 0; i + width <= numbers.size(); i += width) {
    out.put(keyword);
    for (std::size_t d = 0; d < width; ++d) {
      out.put(' ');
      out.put(numbers[i + d]);
    }
    out.put('\n');
  }
}

/// v, v/vt, v//vn or v/vt/vn.
void putCorner(TextWriter& out, std::uint32_t vertex, std::uint32_t texcoord,
               std::uint32_t normal) {
  out.put(' ');
  out.put(vertex + 1);
  if (texcoord == kNoTexcoord && normal == kNoNormal) return;
  out.put('/');
  if (texcoord != kNoTexcoord) out.put(texcoord + 1);
  if (normal == kNoNormal) return;
  out.put('/');
  out.put(normal + 1);
}

}  // namespace

void settleNames(std::vector<MadeMaterial>& materials) {
  std::set<std::string> taken;
  for (MadeMaterial& material : materials) {
    std::string& name = material.name;
    std::replace_if(
        name.begin(), name.end(),
        [](char c) { return static_cast<unsigned char>(c) <= ' ' || c == '#' || c == '\\'; }, '_');
    if (name.empty()) name = "material";
    const std::string wanted = name;
    for (int k = 2; !taken.insert(name).second; ++k) name = wanted + "_" + std::to_string(k);
  }
}

std::string makeMtl(const std::vector<MadeMaterial>& materials) {
  TextWriter out(256 * materials.size());
  for (const MadeMaterial& material : materials) putMaterial(out, material);
  return out.take();
}

std::string makeObj(const PolygonMesh& mesh, const std::vector<double>& uv,
                    const std::vector<std::uint32_t>& cornerUv, const std::string& library,
                    const std::vector<MadeMaterial>& materials) {
  TextWriter out(21 * (mesh.positions.size() + mesh.normals.size()) + 24 * uv.size() +
                 24 * mesh.faceVertices.size());
  putMap(out, "mtllib", library);
  putRows(out, "v", mesh.positions, 3);
  putRows(out, "vt", uv, 2);
  putRows(out, "vn", mesh.normals, 3);
  const auto materialOf = [&](std::size_t f) -> std::size_t {
    return mesh.faceMaterials.empty() ? 0 : mesh.faceMaterials[f];
  };
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    if (f == 0 || materialOf(f) != materialOf(f - 1))
      putMap(out, "usemtl", materials[materialOf(f)].name);
    out.put('f');
    for (std::uint32_t c = mesh.faceOffsets[f]; c < mesh.faceOffsets[f + 1]; ++c)
      putCorner(out, mesh.faceVertices[c], uv.empty() ? kNoTexcoord : cornerUv[c],
                mesh.faceNormals.empty() ? kNoNormal : mesh.faceNormals[c]);
    out.put('\n');
  }
  return out.take();
}

}  // namespace abflat
