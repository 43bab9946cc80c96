#pragma once

#include <string_view>

#include "abflat/io.h"

namespace abflat {

Result<PolygonMesh> readObj(std::string_view bytes, std::string_view fileName);

}  // namespace abflat
