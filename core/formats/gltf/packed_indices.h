#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "gltf/element_shape.h"

namespace abflat::gltf {

/// The least unsigned type from `type` on that holds `highest`, which is not the highest number of
/// the type: that one is reserved.
ComponentType typeFor(ComponentType type, std::uint32_t highest);

/// Numbers of an unsigned type that holds them, one behind the other.
std::string packed(const std::vector<std::uint32_t>& numbers, ComponentType type);

}  // namespace abflat::gltf
