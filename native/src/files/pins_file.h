#pragma once

#include <string>
#include <vector>

#include "abflat/flatten.h"

namespace abflat::cli {

/// Reads pinned vertices from a text file (standard input for "-"), one "VERTEX U V" or "VERTEX U V
/// FACE" per line, counted from 0; blank lines and # comments are skipped. Errors: UnreadableFile,
/// ParseError (names file and line).
Result<std::vector<Pin>> readPins(const std::string& path);

}  // namespace abflat::cli
