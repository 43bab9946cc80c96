#pragma once

#include <string_view>

#include "abflat/io.h"
#include "io/ply_header.h"

namespace abflat {

/// PLY of either encoding. Vertices and faces are read, whatever else there is is stepped over;
/// but the file must end where its header says.
Result<PolygonMesh> readPly(std::string_view bytes, std::string_view fileName);

/// The same where the header is known. `bytes` begin with it.
Result<PolygonMesh> readPlyText(const PlyHeader& header, std::string_view bytes,
                                std::string_view fileName);
Result<PolygonMesh> readPlyBinary(const PlyHeader& header, std::string_view bytes,
                                  std::string_view fileName);

}  // namespace abflat
