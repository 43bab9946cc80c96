#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "abflat/status.h"
#include "batch/batch_input.h"
#include "batch/digest.h"

namespace abflat::cli {

/// One mesh, or several that share an atlas, and what is to be done with it.
struct Task {
  std::string name;                ///< of the mesh or the atlas
  std::vector<BatchInput> inputs;  ///< one, or those of the atlas
  std::vector<std::string>
      outputs;  ///< of each, below the folder of results; empty: none is written
  bool isAtlas = false;
  std::vector<GivenOption> options;  ///< for all meshes and this one
  std::string inputHash;             ///< empty until it is known
  std::string optionsHash;
  std::uintmax_t bytes = 0;  ///< of the files
  double memory = 0;         ///< predicted peak in MB
  std::string picture;       ///< of its layout, below the folder of results; empty: none
};

/// Of what a task reads. Errors: UnreadableFile.
Result<Digest> digestOf(const Task& task);

/// The tasks of a batch, in the order of their names. Options are checked, as the command would.
/// Errors: InvalidOption, also if two meshes would have the same result; UnreadableFile.
Result<std::vector<Task>> planTasks(const BatchCommand& command, std::vector<BatchInput> inputs);

}  // namespace abflat::cli
