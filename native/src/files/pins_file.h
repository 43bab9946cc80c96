#pragma once

#include <string>
#include <vector>

#include "abflat/flatten.h"

namespace abflat::cli {

/// Pinned vertices from a text file (standard input for "-"): a line "VERTEX U V" each, or
/// "VERTEX U V FACE", counted from 0; blank lines and # comments are skipped. Errors:
/// UnreadableFile, ParseError (names file and line).
Result<std::vector<Pin>> readPins(const std::string& path);

}  // namespace abflat::cli
