#pragma once

#include <string>
#include <vector>

#include "abflat/flatten.h"

namespace abflat::cli {

/// Reads straight runs from a text file (standard input for "-"), one "FROM TO" per line, vertices
/// counted from 0; blank lines and # comments are skipped. Errors: UnreadableFile, ParseError
/// (names file and line).
Result<std::vector<StraightRun>> readStraight(const std::string& path);

}  // namespace abflat::cli
