#pragma once

#include "gltf/json.h"

namespace abflat::gltf {

/// Removes an extension from an object, and the `extensions` object along with the last one.
inline void removeExtension(Json& object, const char* name) {
  Json* const extensions = object.find("extensions");
  if (!extensions || !extensions->has(name)) return;
  extensions->erase(name);
  if (extensions->members().empty()) object.erase("extensions");
}

/// The same for all entries of a list.
inline void removeExtension(Json& json, const char* list, const char* name) {
  Json* const found = json.find(list);
  if (!found || !found->isArray()) return;
  for (Json& entry : found->items()) removeExtension(entry, name);
}

}  // namespace abflat::gltf
