#pragma once

#include <array>

#include "gltf/field.h"

namespace abflat::gltf {

/// The two names of one extension of bufferViews and buffers.
constexpr std::array<const char*, 2> kMeshoptExtensions = {"EXT_meshopt_compression",
                                                           "KHR_meshopt_compression"};

/// The extension of a bufferView, if it has it.
inline Field meshoptExtension(const Field& view) {
  const Field extensions = view["extensions"];
  const Field first = extensions[kMeshoptExtensions[0]];
  return first.isPresent() ? first : extensions[kMeshoptExtensions[1]];
}

}  // namespace abflat::gltf
