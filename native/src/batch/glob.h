#pragma once

#include <string>
#include <vector>

namespace abflat::cli {

/// Whether a path has *, ? or [.
bool isPattern(const std::string& path);

/// The files that match, sorted: * and ? are any characters, or any one, of a name, [...] is one of
/// these, and ** is any number of folders. Names that begin with a dot match only a dot.
std::vector<std::string> filesLike(const std::string& pattern);

}  // namespace abflat::cli
