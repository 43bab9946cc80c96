#pragma once

#include <string>
#include <vector>

#include "abflat/unwrap.h"

namespace abflat::cli {

/// Reads edges from a text file, one "VERTEX VERTEX" per line, counted from 0; # starts a comment.
/// Errors: UnreadableFile, ParseError (names file and line).
Result<std::vector<EdgeVertices>> readSeams(const std::string& path);

/// The text of such a file.
std::string seamsText(const std::vector<EdgeVertices>& seams);

}  // namespace abflat::cli
