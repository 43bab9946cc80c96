#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "abflat/gltf_look.h"
#include "base/guarded.h"
#include "gltf/elements.h"
#include "gltf/source.h"
#include "gltf/textures.h"

namespace abflat {
namespace gltf {
namespace {

GltfAlpha alphaOf(const Field& mode) {
  const std::string text = mode.isPresent() ? mode.text() : "OPAQUE";
  if (text == "MASK") return GltfAlpha::Mask;
  if (text == "BLEND") return GltfAlpha::Blend;
  if (text != "OPAQUE") mode.complain("must be OPAQUE, MASK or BLEND");
  return GltfAlpha::Opaque;
}

GltfMaterial materialOf(const Field& material, TextureReader& textures) {
  GltfMaterial out;
  const Field pbr = material["pbrMetallicRoughness"];
  pbr["baseColorFactor"].numbers(out.baseColor.data(), 4);
  out.metallic = pbr["metallicFactor"].number(1);
  out.roughness = pbr["roughnessFactor"].number(1);
  material["emissiveFactor"].numbers(out.emission.data(), 3);
  const double strength =
      material["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"].number(1);
  for (double& value : out.emission) value *= strength;
  out.normalScale = material["normalTexture"]["scale"].number(1);
  out.occlusionStrength = material["occlusionTexture"]["strength"].number(1);
  out.alpha = alphaOf(material["alphaMode"]);
  out.baseColorTexture = textures.read(pbr["baseColorTexture"]);
  out.metallicRoughnessTexture = textures.read(pbr["metallicRoughnessTexture"]);
  out.normalTexture = textures.read(material["normalTexture"]);
  out.occlusionTexture = textures.read(material["occlusionTexture"]);
  out.emissiveTexture = textures.read(material["emissiveTexture"]);
  return out;
}

class LookReader {
 public:
  LookReader(const Source& source, const ReadResource& readResource)
      : source_(source),
        document_(source.document),
        complaints_(document_.fileName),
        textures_(document_, readResource, complaints_) {}

  Result<GltfLook> read() {
    const Field root(&document_.json, "", complaints_);
    const std::vector<Field> materials = root["materials"].items();
    std::map<std::size_t, std::size_t> numbers;
    for (const Part& part : source_.parts) {
      const Primitive& primitive = primitiveOf(part.mesh, part.primitive);
      const auto [place, isNew] = numbers.emplace(primitive.material, out_.materials.size());
      if (isNew && primitive.material == kNone) out_.materials.emplace_back();
      if (isNew && primitive.material != kNone)
        out_.materials.push_back(materialOf(materials[primitive.material], textures_));
      const bool hasTangents = has(primitive, "TANGENT", 4) && has(primitive, "NORMAL", 3);
      out_.parts.push_back(
          {part.firstFace, part.faceCount, place->second, part.isMirrored, hasTangents});
    }
    if (!complaints_.none()) return complaints_.status();
    out_.images = textures_.takeImages();
    out_.corners = source_.faceVertices;
    readTexcoords();
    readColours();
    readFrames();
    return std::move(out_);
  }

 private:
  const Primitive& primitiveOf(std::size_t mesh, std::size_t primitive) const {
    return document_.meshes[mesh][primitive];
  }

  bool has(const Primitive& primitive, const std::string& name, std::size_t components) const {
    const std::size_t accessor = accessorNamed(primitive.attributes, name);
    return accessor != kNone && document_.accessors[accessor].shape.components() == components;
  }

  /// Of all vertices, 0 for those of primitives without the attribute.
  template <class T>
  std::vector<T> attribute(const std::string& name, std::size_t components) const {
    std::vector<T> out(components * source_.vertexCount);
    for (const VertexGroup& group : source_.groups) {
      const Primitive& primitive = primitiveOf(group.mesh, group.primitive);
      if (!has(primitive, name, components)) continue;
      const std::vector<double> values =
          numbersOf(document_, document_.accessors[accessorNamed(primitive.attributes, name)]);
      std::transform(values.begin(), values.end(),
                     out.begin() + static_cast<std::ptrdiff_t>(components * group.firstVertex),
                     [](double x) { return std::isfinite(x) ? static_cast<T>(x) : T(0); });
    }
    return out;
  }

  void readTexcoords() {
    for (const GltfMaterial& material : out_.materials)
      for (const GltfTexture* texture :
           {&material.baseColorTexture, &material.metallicRoughnessTexture, &material.normalTexture,
            &material.occlusionTexture, &material.emissiveTexture}) {
        if (texture->image == kNoImage) continue;
        if (out_.texcoords.size() <= texture->texcoord)
          out_.texcoords.resize(texture->texcoord + 1);
        std::vector<double>& set = out_.texcoords[texture->texcoord];
        if (set.empty())
          set = attribute<double>("TEXCOORD_" + std::to_string(texture->texcoord), 2);
      }
  }

  void readColours() {
    constexpr const char* kName = "COLOR_0";
    for (const VertexGroup& group : source_.groups) {
      const Primitive& primitive = primitiveOf(group.mesh, group.primitive);
      const std::size_t components = has(primitive, kName, 4)   ? 4
                                     : has(primitive, kName, 3) ? 3
                                                                : 0;
      if (components == 0) continue;
      out_.colours.resize(4 * std::size_t{source_.vertexCount}, 1);
      const std::vector<double> values =
          numbersOf(document_, document_.accessors[accessorNamed(primitive.attributes, kName)]);
      for (std::size_t i = 0; i < values.size(); ++i)
        if (std::isfinite(values[i]))
          out_.colours[4 * (group.firstVertex + i / components) + i % components] =
              static_cast<float>(std::clamp(values[i], 0.0, 1.0));
    }
  }

  void readFrames() {
    const bool isNeeded = std::any_of(
        out_.materials.begin(), out_.materials.end(),
        [](const GltfMaterial& material) { return material.normalTexture.image != kNoImage; });
    if (!isNeeded) return;
    out_.positions = attribute<double>("POSITION", 3);
    out_.normals = attribute<float>("NORMAL", 3);
    out_.tangents = attribute<float>("TANGENT", 4);
  }

  const Source& source_;
  const Document& document_;
  Complaints complaints_;
  TextureReader textures_;
  GltfLook out_;
};

}  // namespace
}  // namespace gltf

Result<GltfLook> readGltfLook(const gltf::Source& source, const ReadResource& readResource) {
  return guarded([&] { return gltf::LookReader(source, readResource).read(); });
}

}  // namespace abflat
