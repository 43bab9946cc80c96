#pragma once

#include <string>

#include "abflat/io.h"

namespace abflat::cli {

struct InputMesh {
  std::string bytes;
  MeshFormat format = MeshFormat::Obj;
  PolygonMesh mesh;
};

/// Reads a mesh from a file, or from standard input when `path` is "-".
/// Errors: UnreadableFile, ParseError, OutOfMemory; messages name the file.
Result<InputMesh> readInput(const std::string& path);

}  // namespace abflat::cli
