#pragma once

#include <string>

#include "abflat/appearance.h"

namespace abflat::cli {

/// Reads the files that the mesh at `path` names, relative to its folder ("-": the current one).
/// A mesh may come from anywhere, so that it must not reach for other files of the user: only
/// ordinary files in that folder and below are read, after symbolic links and "..", unless
/// `allowsOutside`. None is read more than a few times.
ReadResource resourcesOf(const std::string& path, bool allowsOutside);

}  // namespace abflat::cli
