#pragma once

#include <string>
#include <vector>

#include "abflat/status.h"
#include "batch/batch_input.h"

namespace abflat::cli {

/// All meshes that a batch names, each once, sorted by name. What lies in the folder of results is
/// left out of folders, and refused where it is named. Errors: UnreadableFile, ParseError,
/// InvalidOption.
Result<std::vector<BatchInput>> findInputs(const BatchCommand& command);

}  // namespace abflat::cli
