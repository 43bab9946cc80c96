#pragma once

#include <string_view>

#include "abflat/io.h"
#include "io/ply_header.h"

namespace abflat {

/// PLY in either encoding. Reads vertices and faces and skips everything else, but the file must
/// end where its header says.
Result<PolygonMesh> readPly(std::string_view bytes, std::string_view fileName);

/// As above, for a known header. `bytes` begin with it.
Result<PolygonMesh> readPlyText(const PlyHeader& header, std::string_view bytes,
                                std::string_view fileName);
Result<PolygonMesh> readPlyBinary(const PlyHeader& header, std::string_view bytes,
                                  std::string_view fileName);

bool looksLikePly(std::string_view bytes);

}  // namespace abflat
