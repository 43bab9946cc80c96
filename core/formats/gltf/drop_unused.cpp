#include "gltf/drop_unused.h"

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

namespace abflat::gltf {
namespace {

constexpr std::array<std::string_view, 3> kLookPrefixes = {"KHR_materials_", "KHR_texture_",
                                                           "EXT_texture_"};
constexpr std::array<std::string_view, 3> kOthers = {"KHR_lights_punctual", "KHR_mesh_quantization",
                                                     "EXT_mesh_gpu_instancing"};

bool isOfLook(std::string_view name) {
  return std::any_of(kLookPrefixes.begin(), kLookPrefixes.end(), [&](std::string_view prefix) {
    return name.substr(0, prefix.size()) == prefix;
  });
}

/// Takes a reference, to be read or replaced.
using Visit = std::function<void(Json& value)>;

template <class Work>
void forEachItem(Json* list, const Work& work) {
  if (list && list->isArray())
    for (Json& item : list->items()) work(item);
}

template <class Work>
void forEachMember(Json* object, const Work& work) {
  if (object)
    for (const auto& member : object->members()) work(*object->find(member.key));
}

void visitMember(Json& object, const char* key, const Visit& visit) {
  if (Json* const value = object.find(key)) visit(*value);
}

/// The content of an extension that an object has.
Json* extensionOf(Json& object, const char* name) {
  Json* const extensions = object.find("extensions");
  return extensions ? extensions->find(name) : nullptr;
}

template <class Work>
void forEachPrimitive(Json& json, const Work& work) {
  forEachItem(json.find("meshes"), [&](Json& mesh) { forEachItem(mesh.find("primitives"), work); });
}

// Each of these visits all references to the entries of one list.

void visitMaterials(Json& json, const Visit& visit) {
  forEachPrimitive(json, [&](Json& primitive) {
    visitMember(primitive, "material", visit);
    if (Json* const variants = extensionOf(primitive, "KHR_materials_variants"))
      forEachItem(variants->find("mappings"),
                  [&](Json& mapping) { visitMember(mapping, "material", visit); });
  });
}

bool isTexture(std::string_view key) {
  constexpr std::string_view kEnd = "Texture";
  return key.size() >= kEnd.size() && key.substr(key.size() - kEnd.size()) == kEnd;
}

/// Extensions have textures at any depth.
void visitTexturesOf(Json& object, const Visit& visit) {
  for (const auto& member : object.members()) {
    if (member.key == "extras") continue;
    Json& value = *object.find(member.key);
    if (isTexture(member.key)) visitMember(value, "index", visit);
    visitTexturesOf(value, visit);
  }
}

void visitTextures(Json& json, const Visit& visit) {
  forEachItem(json.find("materials"), [&](Json& material) { visitTexturesOf(material, visit); });
}

void visitSamplers(Json& json, const Visit& visit) {
  forEachItem(json.find("textures"),
              [&](Json& texture) { visitMember(texture, "sampler", visit); });
}

void visitImages(Json& json, const Visit& visit) {
  forEachItem(json.find("textures"), [&](Json& texture) {
    visitMember(texture, "source", visit);
    forEachMember(texture.find("extensions"),
                  [&](Json& extension) { visitMember(extension, "source", visit); });
  });
}

void visitAccessors(Json& json, const Visit& visit) {
  forEachPrimitive(json, [&](Json& primitive) {
    visitMember(primitive, "indices", visit);
    forEachMember(primitive.find("attributes"), visit);
    forEachItem(primitive.find("targets"), [&](Json& target) { forEachMember(&target, visit); });
  });
  forEachItem(json.find("nodes"), [&](Json& node) {
    if (Json* const instances = extensionOf(node, "EXT_mesh_gpu_instancing"))
      forEachMember(instances->find("attributes"), visit);
  });
  forEachItem(json.find("skins"),
              [&](Json& skin) { visitMember(skin, "inverseBindMatrices", visit); });
  forEachItem(json.find("animations"), [&](Json& animation) {
    forEachItem(animation.find("samplers"), [&](Json& sampler) {
      visitMember(sampler, "input", visit);
      visitMember(sampler, "output", visit);
    });
  });
}

void visitViews(Json& json, const Visit& visit) {
  forEachItem(json.find("accessors"), [&](Json& accessor) {
    visitMember(accessor, "bufferView", visit);
    Json* const sparse = accessor.find("sparse");
    if (!sparse) return;
    for (const char* key : {"indices", "values"})
      if (Json* const part = sparse->find(key)) visitMember(*part, "bufferView", visit);
  });
  forEachItem(json.find("images"), [&](Json& image) { visitMember(image, "bufferView", visit); });
}

/// Drops entries that no reference leads to, and renumbers the references to the others.
void dropFrom(Json& json, const char* list, void (*visitAll)(Json&, const Visit&)) {
  Json* const found = json.find(list);
  if (!found || !found->isArray()) return;
  std::vector<bool> isUsed(found->items().size());
  const auto entryOf = [&](const Json& value) {
    return std::min<std::uint64_t>(value.wholeNumber().value_or(isUsed.size()), isUsed.size());
  };
  visitAll(json, [&](Json& value) {
    if (const std::uint64_t entry = entryOf(value); entry < isUsed.size()) isUsed[entry] = true;
  });
  Json::Items kept;
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < isUsed.size(); ++i) {
    numbers.push_back(kept.size());
    if (isUsed[i]) kept.push_back(std::move(found->items()[i]));
  }
  visitAll(json, [&](Json& value) {
    if (const std::uint64_t entry = entryOf(value); entry < isUsed.size()) value = numbers[entry];
  });
  found->items() = std::move(kept);
  if (found->items().empty()) json.erase(list);
}

std::size_t sizeOf(const Json& view, const char* key) {
  const Json* const found = view.find(key);
  return found ? static_cast<std::size_t>(found->wholeNumber().value_or(0)) : 0;
}

/// Keeps the bytes of views alone, each at the alignment that it had.
void compact(Json& json, std::string& buffer) {
  constexpr std::size_t kAlignment = 8;  // of the largest type in any extension
  Json* const views = json.find("bufferViews");
  if (!views) return;
  std::string out;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> places;
  for (Json& view : views->items()) {
    const std::size_t offset = sizeOf(view, "byteOffset"), length = sizeOf(view, "byteLength");
    const auto [place, isNew] = places.emplace(std::pair(offset, length), 0);
    if (isNew) {
      while (out.size() % kAlignment != offset % kAlignment) out.push_back('\0');
      place->second = out.size();
      out.append(buffer, offset, length);
    }
    if (place->second != offset) view["byteOffset"] = place->second;
  }
  buffer = std::move(out);
  json["buffers"][0]["byteLength"] = buffer.size();
}

/// Names of the extensions that anything in a value has.
void addExtensions(const Json& json, std::set<std::string>& names) {
  for (const Json& item : json.items()) addExtensions(item, names);
  for (const auto& [key, value] : json.members()) {
    if (key == "extensions")
      for (const auto& extension : value.members()) names.insert(extension.key);
    addExtensions(value, names);
  }
}

void dropExtensionNames(Json& json) {
  std::set<std::string> used;
  addExtensions(json, used);
  for (const char* list : {"extensionsUsed", "extensionsRequired"}) {
    Json* const names = json.find(list);
    if (!names || !names->isArray()) continue;
    Json::Items& items = names->items();
    items.erase(std::remove_if(items.begin(), items.end(),
                               [&](const Json& name) {
                                 return name.text() && isOfLook(*name.text()) &&
                                        used.count(*name.text()) == 0;
                               }),
                items.end());
    if (items.empty()) json.erase(list);
  }
}

}  // namespace

bool knowsReferences(const Json& json) {
  const Json* const names = json.find("extensionsUsed");
  if (!names) return true;
  return std::all_of(names->items().begin(), names->items().end(), [](const Json& name) {
    return name.text() && (isOfLook(*name.text()) || std::find(kOthers.begin(), kOthers.end(),
                                                               *name.text()) != kOthers.end());
  });
}

void dropUnused(Json& json, std::string& buffer) {
  // What an entry refers to is dropped after it.
  dropFrom(json, "materials", visitMaterials);
  dropFrom(json, "textures", visitTextures);
  dropFrom(json, "samplers", visitSamplers);
  dropFrom(json, "images", visitImages);
  dropFrom(json, "accessors", visitAccessors);
  dropFrom(json, "bufferViews", visitViews);
  compact(json, buffer);
  dropExtensionNames(json);
}

}  // namespace abflat::gltf
