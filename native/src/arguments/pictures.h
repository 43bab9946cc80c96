#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "abflat/atlas_size.h"

namespace abflat::cli {

/// `endings` are those that the name may have; `inWords` is their text.
CLI::Validator pictureName(const std::vector<std::string>& endings, const std::string& inWords);

void addLayoutPicture(CLI::App& app, std::string& layout);

/// Throws CLI::ValidationError if a picture would be a PNG of more texels than that may have.
void checkPicture(const char* option, const std::string& path, const AtlasSize& resolution);

}  // namespace abflat::cli
