#pragma once

#include <string>

#include "gltf/json.h"

namespace abflat::gltf {

inline constexpr const char* kTextureWebp = "EXT_texture_webp";

/// Adds a name to a list of extensions that does not have it yet.
inline void addOnce(Json& list, const std::string& name) {
  if (!list.isArray()) list = Json::array();
  for (const Json& item : list.items())
    if (item.text() && *item.text() == name) return;
  list.items().emplace_back(name);
}

}  // namespace abflat::gltf
