#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "abflat/io.h"
#include "files/input_file.h"

namespace abflat::cli {

/// "OBJ", "PLY", ...
std::string formatName(FileFormat format);

/// Whether results can be written under this name: it ends in .obj, .ply, .glb or .gltf, or has no
/// ending.
bool isWritableName(const std::string& path);

/// The format that is written under a name; OBJ where it has no ending.
FileFormat writtenFormat(const std::string& path);

/// Texcoords, and the triangles that they were checked for.
struct WrittenLayout {
  const std::vector<double>& uv;
  const std::vector<std::uint32_t>& ofCorner;         ///< per face corner
  const std::vector<std::uint32_t>& triangleCorners;  ///< as for makeGltf
};

/// The file to write as `path`: the input with these texcoords, see writeObj, writePly and
/// writeGltf, makeGltf. `set` is the number of the texcoords in a glTF.
/// Errors: CannotWrite.
Result<std::string> layoutText(const InputMesh& input, const std::string& path, std::size_t set,
                               const WrittenLayout& now);

}  // namespace abflat::cli
