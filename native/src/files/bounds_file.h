#pragma once

#include <string>
#include <vector>

#include "abflat/flatten.h"

namespace abflat::cli {

/// Reads bounds of single vertices from a text file (standard input for "-"), one "VERTEX T" per
/// line; blank lines and # comments are skipped. Errors: UnreadableFile, ParseError (names file and
/// line).
Result<std::vector<VertexBound>> readBounds(const std::string& path);

}  // namespace abflat::cli
