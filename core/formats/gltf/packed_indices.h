#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "gltf/element_shape.h"

namespace abflat::gltf {

/// The narrowest unsigned type, from `type` on, that holds `highest`. The highest number of a type
/// is reserved and does not count.
ComponentType typeFor(ComponentType type, std::uint32_t highest);

/// Numbers in an unsigned type that holds them, tightly packed.
std::string packed(const std::vector<std::uint32_t>& numbers, ComponentType type);

}  // namespace abflat::gltf
