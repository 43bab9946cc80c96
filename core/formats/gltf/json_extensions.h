#pragma once

#include "gltf/json.h"

namespace abflat::gltf {

/// Removes an extension from an object, and the `extensions` object along with the last one.
inline void removeExtension(Json& object, const char* name) {
  const auto extensions = object.is_object() ? object.find("extensions") : object.end();
  if (extensions == object.end() || !extensions->is_object()) return;
  if (extensions->erase(name) > 0 && extensions->empty()) object.erase("extensions");
}

/// The same for all entries of a list.
inline void removeExtension(Json& json, const char* list, const char* name) {
  const auto found = json.find(list);
  if (found == json.end() || !found->is_array()) return;
  for (Json& entry : *found) removeExtension(entry, name);
}

}  // namespace abflat::gltf
