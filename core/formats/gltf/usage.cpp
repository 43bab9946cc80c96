#include "gltf/usage.h"

#include <array>
#include <string_view>

namespace abflat::gltf {
namespace {

/// Extensions whose numbers are never accessors or views.
bool isHarmless(std::string_view extension) {
  constexpr std::array<std::string_view, 4> kPrefixes = {"KHR_materials_", "KHR_texture_",
                                                         "EXT_texture_", "KHR_lights_"};
  for (const std::string_view prefix : kPrefixes)
    if (extension.substr(0, prefix.size()) == prefix) return true;
  return false;
}

/// Entries of a list; empty if there is none.
const Json::Items& listOf(const Json& object, const char* key) {
  static const Json kNull;
  const Json* const found = object.find(key);
  return (found ? *found : kNull).items();
}

void count(const Json& object, const char* key, std::vector<std::size_t>& counts) {
  const Json* const found = object.find(key);
  if (!found || !found->isNumber()) return;
  const double index = *found->number();
  if (index >= 0 && index < static_cast<double>(counts.size()))
    ++counts[static_cast<std::size_t>(index)];
}

}  // namespace

Usage::Usage(const Document& document)
    : accessors_(document.accessors.size(), 0), views_(document.views.size(), 0) {
  for (const std::vector<Primitive>& mesh : document.meshes)
    for (const Primitive& primitive : mesh) {
      for (const auto& [name, accessor] : primitive.attributes) ++accessors_[accessor];
      for (const Attributes& target : primitive.targets)
        for (const auto& [name, accessor] : target) ++accessors_[accessor];
      if (primitive.indices != kNone) ++accessors_[primitive.indices];
    }
  for (const Accessor& a : document.accessors) {
    if (a.view != kNone) ++views_[a.view];
    if (!a.sparse) continue;
    ++views_[a.sparse->indexView];
    ++views_[a.sparse->valueView];
  }
  countAccessors(document.json);
  for (const Json& image : listOf(document.json, "images")) count(image, "bufferView", views_);
  countUnknown(document.json, false);
}

void Usage::countAccessors(const Json& json) {
  for (const Json& skin : listOf(json, "skins")) count(skin, "inverseBindMatrices", accessors_);
  for (const Json& animation : listOf(json, "animations"))
    for (const Json& sampler : listOf(animation, "samplers"))
      for (const char* key : {"input", "output"}) count(sampler, key, accessors_);
}

void Usage::countUnknown(const Json& json, bool isUnknown) {
  if (json.isInteger() && isUnknown) {
    const double index = *json.number();
    for (std::vector<std::size_t>* counts : {&accessors_, &views_})
      if (index >= 0 && index < static_cast<double>(counts->size()))
        ++(*counts)[static_cast<std::size_t>(index)];
  }
  for (const Json& item : json.items()) countUnknown(item, isUnknown);
  for (const auto& [key, value] : json.members())
    if (!isHarmless(key)) countUnknown(value, isUnknown || key == "extensions" || key == "extras");
}

void Usage::release(const Accessor& accessor) {
  if (accessor.view != kNone) --views_[accessor.view];
  if (!accessor.sparse) return;
  --views_[accessor.sparse->indexView];
  --views_[accessor.sparse->valueView];
}

}  // namespace abflat::gltf
