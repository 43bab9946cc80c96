#pragma once

#include <string>
#include <vector>

#include "abflat/verify.h"

namespace abflat::cli {

/// Sets options from a JSON file: an object whose keys are their names. `isGiven`: per option,
/// those that stay as they are. Errors: UnreadableFile, ParseError, InvalidOption; messages name
/// the file.
Status readRules(const std::string& path, const std::vector<bool>& isGiven,
                 VerifyOptionValues& options);

}  // namespace abflat::cli
