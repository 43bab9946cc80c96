#pragma once

#include "abflat/io.h"

namespace abflat {

/// How a format is recognised, read and written.
struct FormatFunctions {
  MeshFormat format;
  bool beginsFreely;  ///< what would be a byte order mark in a text means nothing
  bool (*looksLike)(std::string_view bytes);
  Result<PolygonMesh> (*read)(std::string_view bytes, std::string_view fileName);
  decltype(&writeObj) write;  ///< null for a format that is only read
};

/// In the order in which a file of unknown name is tried: what takes most files comes last.
extern const FormatFunctions kFormatFunctions[kMeshFormatCount];

const FormatFunctions& functionsOf(MeshFormat format);

}  // namespace abflat
