#pragma once

#include <string>
#include <vector>

#include "abflat/status.h"
#include "batch/task.h"

namespace abflat::cli {

/// Where the files of one task lie until they are complete.
struct WorkPlace {
  std::string folder;               ///< of this task alone
  std::vector<std::string> meshes;  ///< each in a folder for it and what it needs
  std::string report, layout, said;
  std::string parts;  ///< list of the meshes of an atlas
};

/// A folder within that of results for files that are not complete. A run that was killed leaves
/// its own, which the next one removes.
class WorkFolder {
 public:
  /// `tag` tells runs apart that work in the same folder at the same time.
  WorkFolder(std::string out, const std::string& tag);
  ~WorkFolder();
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;

  /// Removes those of earlier runs, and makes one. Errors: CannotWrite.
  Status make();
  /// Makes room for a task. Errors: CannotWrite.
  Result<WorkPlace> placeFor(std::size_t number, const Task& task) const;
  static void remove(const WorkPlace& place);

 private:
  const std::string out_, prefix_;
  std::string path_;
};

}  // namespace abflat::cli
