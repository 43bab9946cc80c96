#pragma once

#include <string>

#include "abflat/appearance.h"

namespace abflat::cli {

/// Reads the files that the mesh at `path` names, relative to its folder ("-": the current one). A
/// mesh may come from anywhere, so it must not be able to reach the user's other files: only
/// ordinary files in that folder and below are read, after resolving symbolic links and "..",
/// unless `allowsOutside`. No file is read more than a few times.
ReadResource resourcesOf(const std::string& path, bool allowsOutside);

}  // namespace abflat::cli
