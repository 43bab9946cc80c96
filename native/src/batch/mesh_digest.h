#pragma once

#include <string>
#include <vector>

#include "batch/batch_input.h"
#include "batch/digest.h"

namespace abflat::cli {

/// Of a mesh, with the buffers and images that a glTF names and the material files of an OBJ.
/// Errors: UnreadableFile.
Result<Digest> meshDigest(const std::string& path);

/// Of the meshes of an atlas, with their names, which the results have. Errors: UnreadableFile.
Result<Digest> atlasDigest(const std::vector<BatchInput>& meshes);

}  // namespace abflat::cli
