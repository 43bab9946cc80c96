#pragma once

#include <string>
#include <string_view>

#include "abflat/status.h"
#include "gltf/json.h"

namespace abflat::gltf {

/// The JSON of a glTF 2.0 file whose meshes can be read. Errors: ParseError.
Result<Json> readJson(std::string_view text, const std::string& fileName);

}  // namespace abflat::gltf
