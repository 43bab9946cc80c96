#pragma once

#include <string>

#include "batch/manifest.h"

namespace abflat::cli {

/// Makes one manifest of those of all parts in a folder, and returns its lines. Errors:
/// UnreadableFile if there is none, or one is missing; InvalidOption if parts do not belong
/// together; CannotWrite.
Result<ManifestLines> mergeManifests(const std::string& out);

}  // namespace abflat::cli
