#include "baking/bake_look_obj.h"

#include <chrono>
#include <utility>

namespace abflat::cli {
namespace {

// As in the images of a baked OBJ.
constexpr const char* kDiffuse = "diffuse";
constexpr const char* kRoughness = "roughness";
constexpr const char* kMetallic = "metallic";
constexpr const char* kNormal = "normal";
constexpr const char* kEmissive = "emissive";

BakedMap channelOf(const BakedMap& map, std::size_t channel, const char* name) {
  BakedMap out{map.plan, {map.image.width, map.image.height, 1, map.image.bits, {}}};
  out.plan.name = name;
  out.plan.channels = 1;
  const auto step = static_cast<std::size_t>(map.image.channels);
  out.image.pixels.reserve(map.image.pixels.size() / step);
  for (std::size_t i = channel; i < map.image.pixels.size(); i += step)
    out.image.pixels.push_back(map.image.pixels[i]);
  return out;
}

class ObjLookMaker {
 public:
  ObjLookMaker(const OldLook& old, const BakeOptionValues& options, std::string stem,
               const std::vector<std::string>& names)
      : options_(options), stem_(std::move(stem)) {
    const std::vector<GltfMaterial>& materials = old.look.materials;
    for (std::size_t m = 0; m < materials.size(); ++m)
      out_.materials.push_back(
          numbersOf(materials[m], m < names.size() ? names[m] : std::string()));
    settleNames(out_.materials);
    for (const GltfMaterial& material : materials)
      isOpaque_.push_back(material.alpha == GltfAlpha::Opaque);
  }

  Result<LookOfObj> make(BakedMaps baked) {
    for (BakedMap& map : baked.maps)
      if (Status s = put(map, baked.emissiveStrength); !s.ok()) return s;
    return std::move(out_);
  }

 private:
  static MadeMaterial numbersOf(const GltfMaterial& from, const std::string& name) {
    MadeMaterial out;
    out.name = name;
    for (std::size_t d = 0; d < 3; ++d) out.colour[d] = from.baseColor[d];
    out.opacity = from.alpha == GltfAlpha::Opaque ? 1 : from.baseColor[3];
    out.emission = from.emission;
    out.metallic = from.metallic;
    out.roughness = from.roughness;
    return out;
  }

  Status put(BakedMap& map, double emissiveStrength) {
    const TexturePlace place = map.plan.texture;
    if (place == &GltfMaterial::baseColorTexture) return putColour(map);
    if (place == kMetallicRoughnessPlace) {
      if (Status s = put(channelOf(map, 1, kRoughness), &MadeMaterial::roughnessMap); !s.ok())
        return s;
      for (MadeMaterial& material : out_.materials) material.roughness = material.metallic = 1;
      return put(channelOf(map, 2, kMetallic), &MadeMaterial::metallicMap);
    }
    if (place == &GltfMaterial::normalTexture) return put(map, kNormal, &MadeMaterial::normalMap);
    if (place == kOcclusionPlace) {
      out_.notes.emplace_back(
          "occlusion was left out, because materials of an OBJ have no such map");
      return {};
    }
    for (MadeMaterial& material : out_.materials)
      material.emission = {emissiveStrength, emissiveStrength, emissiveStrength};
    return put(map, kEmissive, &MadeMaterial::emissionMap);
  }

  Status putColour(BakedMap& map) {
    if (Status s = put(map, kDiffuse, &MadeMaterial::colourMap); !s.ok()) return s;
    for (std::size_t m = 0; m < out_.materials.size(); ++m) {
      MadeMaterial& material = out_.materials[m];
      material.colour = {1, 1, 1};
      material.opacity = 1;
      // Programs take the alpha of such an image.
      if (!isOpaque_[m]) material.opacityMap = material.colourMap;
    }
    return {};
  }

  Status put(BakedMap& map, const char* name, std::string MadeMaterial::*place) {
    map.plan.name = name;
    return put(std::as_const(map), place);
  }

  Status put(const BakedMap& map, std::string MadeMaterial::*place) {
    Result<ImageFile> file = writeMap(map, options_, out_.report, out_.notes);
    if (!file.ok()) return file.status();
    ImageFile& image = out_.images.emplace_back(std::move(file).value());
    image.name = stem_ + "-" + map.plan.name + images::endingOf(out_.report.maps.back().format);
    for (MadeMaterial& material : out_.materials) material.*place = image.name;
    return {};
  }

  const BakeOptionValues& options_;
  const std::string stem_;
  std::vector<bool> isOpaque_;  ///< by material
  LookOfObj out_;
};

}  // namespace

Result<LookOfObj> bakeLookOfObj(OldLook& old, const NewLayout& layout,
                                const BakeOptionValues& options, const std::string& stem,
                                const std::vector<std::string>& names) {
  const auto start = std::chrono::steady_clock::now();
  Result<BakedMaps> baked = bakeMaps(old, layout, options);
  if (!baked.ok()) return baked.status();
  const bool hasNone = baked.value().maps.empty();
  Result<LookOfObj> out = ObjLookMaker(old, options, stem, names).make(std::move(baked).value());
  if (!out.ok()) return out;
  noteOld(old, hasNone, out.value().report, out.value().notes);
  out.value().report.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return out;
}

std::vector<std::string> lookOfObjNames(const std::string& stem, ImageFormat format) {
  std::vector<std::string> out;
  for (const char* name : {kDiffuse, kRoughness, kMetallic, kNormal, kEmissive})
    for (const ImageFormat each : {format, ImageFormat::Png})
      out.push_back(stem + "-" + name + images::endingOf(each));
  return out;
}

}  // namespace abflat::cli
