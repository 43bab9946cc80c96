#pragma once

#include <cstddef>
#include <string_view>

#include "abflat/mesh.h"
#include "abflat/status.h"

namespace abflat {

/// What a binary OFF file says before its numbers.
struct OffBinaryHeader {
  std::size_t size = 0;           ///< in bytes
  std::size_t vertexNumbers = 3;  ///< floats per vertex: position, normal, colour, texcoord
};

/// Reads the numbers of a binary OFF file: big-endian, each face followed by its colour, as
/// Geomview defines it. Some programs write little-endian numbers, or no colours; what fits the
/// file exactly is taken. Errors: ParseError (names the byte).
Result<PolygonMesh> readOffBinary(const OffBinaryHeader& header, std::string_view bytes,
                                  std::string_view fileName);

}  // namespace abflat
