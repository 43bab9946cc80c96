#include <set>
#include <string>
#include <string_view>

#include "abflat/gltf.h"
#include "gltf/source.h"
#include "gltf/triangles.h"

namespace abflat {
namespace gltf {
namespace {

/// A whole number, 0 or more, or `fallback`.
std::size_t numberOf(const Json* json, std::size_t fallback) {
  return json ? json->wholeNumber().value_or(fallback) : fallback;
}

bool isTextureInfo(std::string_view key, const Json& json) {
  constexpr std::string_view kEnd = "Texture";
  return key.size() >= kEnd.size() && key.substr(key.size() - kEnd.size()) == kEnd &&
         json.has("index");
}

/// KHR_texture_transform may specify another set.
std::size_t setOf(const Json& texture) {
  const std::size_t set = numberOf(texture.find("texCoord"), 0);
  const Json* const extensions = texture.find("extensions");
  const Json* const transform = extensions ? extensions->find("KHR_texture_transform") : nullptr;
  return transform ? numberOf(transform->find("texCoord"), set) : set;
}

/// Texcoord sets of all textures of a material, including those of its extensions; or, with
/// `isBaked`, of these alone.
void addSets(const Json& material, std::set<std::size_t>& sets, bool isBaked = false) {
  for (const auto& [key, value] : material.members()) {
    if (key == "extras") continue;
    if (isTextureInfo(key, value) && !isBaked) sets.insert(setOf(value));
    addSets(value, sets, isBaked && key != "extensions");
  }
}

/// Materials that extensions of a primitive refer to, such as variants.
void addMaterials(const Json& json, std::set<std::size_t>& materials) {
  for (const Json& item : json.items()) addMaterials(item, materials);
  for (const auto& [key, value] : json.members()) {
    if (key == "material") materials.insert(numberOf(&value, kNone));
    addMaterials(value, materials);
  }
}

class TextureSets {
 public:
  explicit TextureSets(const Document& document, bool isBaked = false) {
    std::set<std::size_t> materials, others;
    for (std::size_t m = 0; m < document.meshes.size(); ++m)
      for (std::size_t p = 0; p < document.meshes[m].size(); ++p) {
        const Primitive& primitive = document.meshes[m][p];
        if (!hasTriangles(primitive.mode)) continue;
        materials.insert(primitive.material);
        const Json& json = document.json["meshes"][m]["primitives"][p];
        if (const Json* extensions = json.find("extensions")) addMaterials(*extensions, others);
        for (const auto& attribute : primitive.attributes) names_.insert(attribute.first);
      }
    const Json* const list = document.json.find("materials");
    const std::size_t count = list ? list->items().size() : 0;
    for (const std::size_t m : materials)
      if (m < count) addSets((*list)[m], sampled_, isBaked);
    for (const std::size_t m : others)
      if (m < count) addSets((*list)[m], sampled_);
  }

  bool isSampled(std::size_t set) const { return sampled_.count(set) > 0; }
  bool isTaken(std::size_t set) const {
    return isSampled(set) || names_.count("TEXCOORD_" + std::to_string(set)) > 0;
  }

 private:
  std::set<std::size_t> sampled_;
  std::set<std::string> names_;  ///< of attributes
};

}  // namespace
}  // namespace gltf

std::size_t freeTexcoord(const gltf::Source& source, bool isBaked) {
  const gltf::TextureSets sets(source.document, isBaked);
  if (!sets.isSampled(0)) return 0;
  std::size_t out = 1;
  while (sets.isTaken(out)) ++out;
  return out;
}

std::string texcoordNote(const gltf::Source& source, std::size_t texcoord) {
  const std::string name = "TEXCOORD_" + std::to_string(texcoord);
  if (texcoord == 1)
    return "a texture uses TEXCOORD_0, so the new texcoords are " + name +
           ". Use --texcoord 0 to replace the old ones";
  const bool isUsed = gltf::TextureSets(source.document).isSampled(1);
  return std::string(isUsed ? "textures use TEXCOORD_0 and TEXCOORD_1"
                            : "a texture uses TEXCOORD_0, and TEXCOORD_1 exists") +
         ", so the new texcoords are " + name + ". Many programs read only the first two sets. " +
         (isUsed ? "Use --texcoord 0 to replace the first"
                 : "Use --texcoord 1 to replace the second, which no texture uses");
}

}  // namespace abflat
