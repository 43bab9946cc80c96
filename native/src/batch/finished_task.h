#pragma once

#include <string>

#include "batch/child.h"
#include "batch/manifest_line.h"
#include "batch/task.h"
#include "batch/work_folder.h"

namespace abflat::cli {

/// How a task was ended by this program, if it was.
struct TaskEnd {
  ChildEnd child;
  double seconds = 0;
  double timeLimit = 0;    ///< seconds; 0 if it was not ended for that
  double memoryLimit = 0;  ///< MB that it was given; 0: any
};

/// Puts the files of a task in their places in the folder of results, and says what became of it.
ManifestLine finishedTask(const Task& task, const WorkPlace& place, const TaskEnd& end,
                          const std::string& out);

}  // namespace abflat::cli
