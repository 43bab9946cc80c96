#pragma once

#include <string_view>

#include "abflat/io.h"

namespace abflat {

/// OFF, text or binary, and its variants (COFF, NOFF, STOFF and combinations), whose extra columns
/// are skipped.
Result<PolygonMesh> readOff(std::string_view bytes, std::string_view fileName);

/// Whether the first line that is not empty or a comment belongs to an OFF header.
bool looksLikeOff(std::string_view bytes);

}  // namespace abflat
