#pragma once

#include <set>
#include <string>
#include <vector>

#include "batch/manifest.h"
#include "batch/task.h"

namespace abflat::cli {

/// A batch from the meshes that it names to its manifest.
class BatchRun {
 public:
  explicit BatchRun(const BatchCommand& command);

  /// Finds the meshes and what is to be done with them. Errors: those of findInputs and planTasks,
  /// UnreadableFile.
  Status plan();
  /// What would be done, for people to read.
  std::string planText() const;
  /// Errors: CannotWrite; InvalidOption if the folder has other results; Aborted.
  Status run();

  const ManifestLines& lines() const { return manifest_.lines(); }
  std::size_t settled() const { return settled_; }

 private:
  Status keepShard();
  Status checkFolder() const;
  Status makeFolder() const;
  void chooseWanted(const ManifestLines& lines);
  std::string textOf(const Task& task) const;
  std::string pathOf(const std::string& name) const;

  const BatchCommand& command_;
  Manifest manifest_;
  std::vector<Task> tasks_;
  std::vector<std::size_t> wanted_;  ///< tasks that are not settled
  std::size_t settled_ = 0;
};

}  // namespace abflat::cli
