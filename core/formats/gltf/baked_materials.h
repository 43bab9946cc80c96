#pragma once

#include <string>

#include "gltf/source.h"

namespace abflat::gltf {

/// Has the primitives of the mesh use materials with new images, which are added to the file's only
/// buffer, at texcoords of one set. Tangents go if there is a new normal map: they were those of
/// the old texcoords, and without any, programs compute those that the map is made for.
void putBaked(const Source& source, const GltfBaked& baked, std::size_t texcoord, Json& json,
              std::string& buffer);

}  // namespace abflat::gltf
