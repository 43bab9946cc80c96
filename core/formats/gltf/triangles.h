#pragma once

#include <cstdint>
#include <vector>

#include "gltf/document.h"

namespace abflat::gltf {

/// Whether a primitive is made of triangles.
bool hasTriangles(Mode mode);

/// Three vertices for each triangle of a list, strip or fan; an incomplete one is dropped.
std::vector<std::uint32_t> asTriangles(Mode mode, std::vector<std::uint32_t> vertices);

}  // namespace abflat::gltf
