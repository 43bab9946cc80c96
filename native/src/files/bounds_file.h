#pragma once

#include <string>
#include <vector>

#include "abflat/flatten.h"

namespace abflat::cli {

/// Bounds of single vertices from a text file (standard input for "-"): a line "VERTEX T" each;
/// blank lines and # comments are skipped. Errors: UnreadableFile, ParseError (names file and
/// line).
Result<std::vector<VertexBound>> readBounds(const std::string& path);

}  // namespace abflat::cli
