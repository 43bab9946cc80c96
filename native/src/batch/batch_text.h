#pragma once

#include <string>

#include "batch/manifest.h"

namespace abflat::cli {

/// A few lines about all meshes of a manifest, with why some have failed.
std::string batchText(const ManifestLines& lines, const std::string& manifest);

}  // namespace abflat::cli
