#pragma once

#include <string>

#include "abflat/io.h"

namespace abflat::cli {

struct InputMesh {
  std::string bytes;
  MeshFormat format = MeshFormat::Obj;
  PolygonMesh mesh;
};

/// All bytes of a file, or of standard input when `path` is "-".
/// Errors: UnreadableFile; the message names the file.
Result<std::string> readBytes(const std::string& path);

/// Reads a mesh from a file, or from standard input when `path` is "-".
/// Errors: UnreadableFile, ParseError, OutOfMemory; messages name the file.
Result<InputMesh> readInput(const std::string& path);

}  // namespace abflat::cli
