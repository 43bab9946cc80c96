#pragma once

#include <string>
#include <vector>

#include "abflat/status.h"
#include "batch/batch_input.h"

namespace abflat::cli {

/// The meshes that a list names (standard input for "-"), whose relative paths start at the folder
/// of the list. It has a path a line; or it is CSV with a column "input", or JSON Lines with a key
/// "input", and others are options in `known`. Errors: UnreadableFile, ParseError, InvalidOption;
/// messages name file and line.
Result<std::vector<BatchInput>> readList(const std::string& path,
                                         const std::vector<OptionOfCommand>& known);

}  // namespace abflat::cli
