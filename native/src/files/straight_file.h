#pragma once

#include <string>
#include <vector>

#include "abflat/flatten.h"

namespace abflat::cli {

/// Straight runs from a text file (standard input for "-"): a line "FROM TO" each, vertices counted
/// from 0; blank lines and # comments are skipped. Errors: UnreadableFile, ParseError (names file
/// and line).
Result<std::vector<StraightRun>> readStraight(const std::string& path);

}  // namespace abflat::cli
