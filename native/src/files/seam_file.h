#pragma once

#include <string>
#include <vector>

#include "abflat/unwrap.h"

namespace abflat::cli {

/// Edges from a text file, a line "VERTEX VERTEX" each, counted from 0; # begins a comment.
/// Errors: UnreadableFile, ParseError (names file and line).
Result<std::vector<EdgeVertices>> readSeams(const std::string& path);

/// The text of such a file.
std::string seamsText(const std::vector<EdgeVertices>& seams);

}  // namespace abflat::cli
