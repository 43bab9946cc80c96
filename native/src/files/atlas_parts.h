#pragma once

#include <string>
#include <vector>

#include "abflat/status.h"

namespace abflat::cli {

/// One of the meshes that share an atlas.
struct AtlasPart {
  std::string input, output;
  std::string movedTo;  ///< where the output will lie
};

/// A file that tells them to the process that unwraps them, since a command line can only be so
/// long. It is for this program alone.
std::string atlasPartsText(const std::vector<AtlasPart>& parts);

/// Errors: UnreadableFile, ParseError.
Result<std::vector<AtlasPart>> readAtlasParts(const std::string& path);

}  // namespace abflat::cli
