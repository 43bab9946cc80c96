#pragma once

#include <string>

#include "batch/manifest.h"

namespace abflat::cli {

/// A page about all meshes of a manifest, for the folder of results: a table to sort, with pictures
/// and links to files in and beside that folder. It needs nothing else.
std::string reportPage(const ManifestLines& lines, const std::string& out);

}  // namespace abflat::cli
