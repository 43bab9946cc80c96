#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace abflat::cli {

/// The JSON of a glTF, whether it is a file of its own or the beginning of a GLB; discarded if
/// there is none.
nlohmann::json gltfJson(const std::string& path);

}  // namespace abflat::cli
