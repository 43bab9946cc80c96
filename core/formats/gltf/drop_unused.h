#pragma once

#include <string>

#include "gltf/json.h"

namespace abflat::gltf {

/// Whether all that may refer to an entry of a list is known: no extension of the file is strange.
bool knowsReferences(const Json& json);

/// Drops materials, textures, samplers, images, accessors and views that nothing refers to,
/// together with the bytes that only they hold, and the names of extensions of materials and
/// textures that nothing has. `json` has one buffer. To be asked for only if knowsReferences.
void dropUnused(Json& json, std::string& buffer);

}  // namespace abflat::gltf
