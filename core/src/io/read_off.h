#pragma once

#include <string_view>

#include "abflat/io.h"

namespace abflat {

/// OFF, and COFF, NOFF, STOFF and their combinations, whose extra columns are skipped. Text only.
Result<PolygonMesh> readOff(std::string_view bytes, std::string_view fileName);

}  // namespace abflat
