#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "abflat/status.h"
#include "batch/batch_input.h"

namespace abflat::cli {

/// One mesh, and what is to be done with it.
struct Task {
  BatchInput input;
  std::string output;                ///< below the folder of results; empty: no mesh is written
  std::vector<GivenOption> options;  ///< for all meshes and this one
  std::string inputHash;             ///< empty until it is known
  std::string optionsHash;
  std::uintmax_t bytes = 0;  ///< of the file
  double memory = 0;         ///< predicted peak in MB
  std::string picture;       ///< of its layout, below the folder of results; empty: none
};

/// The tasks of a batch, in the order of their names. Options are checked, as the command would.
/// Errors: InvalidOption, also if two meshes would have the same result; UnreadableFile.
Result<std::vector<Task>> planTasks(const BatchCommand& command, std::vector<BatchInput> inputs);

}  // namespace abflat::cli
