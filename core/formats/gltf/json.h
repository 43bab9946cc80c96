#pragma once

#include <nlohmann/json.hpp>

namespace abflat::gltf {

/// Preserves the order of keys in the file.
using Json = nlohmann::ordered_json;

}  // namespace abflat::gltf
