#include "gltf/baked_materials.h"

#include <map>
#include <set>
#include <utility>

#include "gltf/json_extensions.h"
#include "gltf/used_extensions.h"

namespace abflat::gltf {
namespace {

constexpr const char* kStrength = "KHR_materials_emissive_strength";
constexpr std::size_t kImageAlignment = 4;

/// With members in the order of their names.
Json sorted(const Json& json) {
  if (json.isArray()) {
    Json out = Json::array();
    for (const Json& item : json.items()) out.items().push_back(sorted(item));
    return out;
  }
  if (!json.isObject()) return json;
  std::set<std::string> keys;
  for (const auto& member : json.members()) keys.insert(member.key);
  Json out = Json::object();
  for (const std::string& key : keys) out[key] = sorted(json[key]);
  return out;
}

/// The same text for materials that are drawn alike.
std::string contentOf(Json material) {
  material.erase("name");
  const Json* const mode = material.find("alphaMode");
  const std::string* const text = mode ? mode->text() : nullptr;
  if (!text || *text != "MASK") material.erase("alphaCutoff");
  if (text && *text == "OPAQUE") material.erase("alphaMode");
  const Json* const isDouble = material.find("doubleSided");
  if (isDouble && isDouble->flag() && !*isDouble->flag()) material.erase("doubleSided");
  return sorted(material).dump(false);
}

class BakedMaterials {
 public:
  BakedMaterials(const Source& source, const GltfBaked& baked, std::size_t texcoord, Json& json,
                 std::string& buffer)
      : source_(source), baked_(baked), texcoord_(texcoord), json_(json), buffer_(buffer) {}

  void put() {
    for (const ImageFile& image : baked_.images) addTexture(image);
    std::map<std::size_t, std::size_t> numbers;
    for (const Part& part : source_.parts) {
      const std::size_t old = source_.document.meshes[part.mesh][part.primitive].material;
      const auto [place, isNew] = numbers.emplace(old, 0);
      if (isNew) place->second = numberOf(materialOf(old));
      Json& primitive = json_["meshes"][part.mesh]["primitives"][part.primitive];
      primitive["material"] = place->second;
      if (baked_.baseColor != kNoImage) eraseAttribute(primitive, "COLOR_0");
      if (baked_.normal != kNoImage) eraseAttribute(primitive, "TANGENT");
    }
  }

 private:
  /// What the images now hold, or were made for.
  static void eraseAttribute(Json& primitive, const char* name) {
    primitive["attributes"].erase(name);
    if (Json* const targets = primitive.find("targets"))
      for (Json& target : targets->items()) target.erase(name);
  }

  std::size_t addView(const std::string& bytes) {
    buffer_.resize((buffer_.size() + kImageAlignment - 1) / kImageAlignment * kImageAlignment);
    Json view = Json::object();
    view["buffer"] = 0;
    view["byteOffset"] = buffer_.size();
    view["byteLength"] = bytes.size();
    buffer_ += bytes;
    json_["buffers"][0]["byteLength"] = buffer_.size();
    return add("bufferViews", std::move(view));
  }

  std::size_t add(const char* list, Json entry) {
    Json::Items& items = json_[list].items();
    items.push_back(std::move(entry));
    return items.size() - 1;
  }

  void addTexture(const ImageFile& file) {
    Json image = Json::object();
    image["name"] = file.name;
    image["mimeType"] = file.mimeType;
    image["bufferView"] = addView(file.bytes);
    Json texture = Json::object();
    const std::size_t number = add("images", std::move(image));
    if (file.mimeType == "image/webp") {
      texture["extensions"][kTextureWebp]["source"] = number;
      addOnce(json_["extensionsUsed"], kTextureWebp);
      addOnce(json_["extensionsRequired"], kTextureWebp);
    } else {
      texture["source"] = number;
    }
    textures_.push_back(add("textures", std::move(texture)));
  }

  void setTexture(Json& object, const char* key, std::size_t image) const {
    if (image == kNoImage) return;
    Json info = Json::object();
    info["index"] = textures_[image];
    if (texcoord_ != 0) info["texCoord"] = texcoord_;
    object[key] = std::move(info);
  }

  /// A material of the file with what the images now hold left out.
  Json materialOf(std::size_t old) const {
    Json out = old == kNone ? Json::object() : source_.document.json["materials"][old];
    if (baked_.baseColor != kNoImage || baked_.metallicRoughness != kNoImage) {
      Json& pbr = out["pbrMetallicRoughness"];
      if (baked_.baseColor != kNoImage) pbr.erase("baseColorFactor");
      if (baked_.metallicRoughness != kNoImage)
        for (const char* key : {"metallicFactor", "roughnessFactor"}) pbr.erase(key);
      setTexture(pbr, "baseColorTexture", baked_.baseColor);
      setTexture(pbr, "metallicRoughnessTexture", baked_.metallicRoughness);
    }
    setTexture(out, "normalTexture", baked_.normal);
    setTexture(out, "occlusionTexture", baked_.occlusion);
    setTexture(out, "emissiveTexture", baked_.emissive);
    if (baked_.emissive != kNoImage) setEmission(out);
    return out;
  }

  void setEmission(Json& material) const {
    material["emissiveFactor"] = std::array<double, 3>{1, 1, 1};
    removeExtension(material, kStrength);
    if (baked_.emissiveStrength == 1) return;
    material["extensions"][kStrength]["emissiveStrength"] = baked_.emissiveStrength;
    addOnce(json_["extensionsUsed"], kStrength);
  }

  /// Of a new material that is drawn alike, or else of this one.
  std::size_t numberOf(Json material) {
    const auto [place, isNew] = known_.emplace(contentOf(material), 0);
    if (isNew) place->second = add("materials", std::move(material));
    return place->second;
  }

  const Source& source_;
  const GltfBaked& baked_;
  std::size_t texcoord_;
  Json& json_;
  std::string& buffer_;
  std::vector<std::size_t> textures_;         ///< by new image
  std::map<std::string, std::size_t> known_;  ///< new materials by their content
};

}  // namespace

void putBaked(const Source& source, const GltfBaked& baked, std::size_t texcoord, Json& json,
              std::string& buffer) {
  BakedMaterials(source, baked, texcoord, json, buffer).put();
}

}  // namespace abflat::gltf
