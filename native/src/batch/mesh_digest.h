#pragma once

#include <string>

#include "batch/digest.h"

namespace abflat::cli {

/// Of a mesh, with the buffers and images that a glTF names and the material files of an OBJ.
/// Errors: UnreadableFile.
Result<Digest> meshDigest(const std::string& path);

}  // namespace abflat::cli
