#pragma once

#include <string_view>

#include "abflat/io.h"

namespace abflat {

Result<PolygonMesh> readObj(std::string_view bytes, std::string_view fileName);

/// Whether anything among the first lines means something in an OBJ.
bool looksLikeObj(std::string_view bytes);

}  // namespace abflat
