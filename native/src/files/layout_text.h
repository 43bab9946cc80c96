#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "abflat/io.h"
#include "files/input_file.h"

namespace abflat::cli {

/// Texcoords, and the triangles for which they were checked.
struct WrittenLayout {
  const std::vector<double>& uv;
  const std::vector<std::uint32_t>& ofCorner;         ///< per face corner
  const std::vector<std::uint32_t>& triangleCorners;  ///< as for makeGltf
  const std::vector<std::uint32_t>& turnedFaces;  ///< that the mesh has turned since it was read
  const GltfBaked* baked = nullptr;               ///< as in GltfWriteOptions
  bool isMadeBaked = false;                       ///< as in GltfMakeOptions
};

/// The content to write to `path`: the input with these texcoords, see writeMesh,
/// writeGltf and makeGltf. `set` is the number of the texcoord set in a glTF. Errors: CannotWrite.
Result<std::string> layoutText(const InputFile& input, const std::string& path, std::size_t set,
                               const WrittenLayout& now);

}  // namespace abflat::cli
