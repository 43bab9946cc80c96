#pragma once

#include <string>
#include <string_view>

#include "abflat/status.h"

namespace abflat::gltf {

/// The parts of a .glb or .gltf file; they refer to the bytes of the file.
struct Container {
  bool isBinary = false;
  std::string_view json;
  bool hasBuffer = false;
  std::string_view buffer;  ///< the one inside a .glb
  std::string_view others;  ///< further chunks of a .glb, of unknown meaning
};

/// Whether the file begins like a .glb, or may be a .gltf.
bool looksLikeGltf(std::string_view bytes);

/// Errors: ParseError.
Result<Container> openContainer(std::string_view bytes, const std::string& fileName);

/// A .glb file. Errors: CannotWrite if it would have 4 GB or more.
Result<std::string> binaryFile(std::string_view json, std::string_view buffer,
                               std::string_view others);

}  // namespace abflat::gltf
