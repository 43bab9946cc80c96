#pragma once

#include <nlohmann/json.hpp>

namespace abflat::gltf {

/// Keys keep the order of the file.
using Json = nlohmann::ordered_json;

}  // namespace abflat::gltf
