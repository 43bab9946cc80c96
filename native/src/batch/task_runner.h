#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <vector>

#include "abflat/status.h"
#include "batch/batch_progress.h"
#include "batch/child.h"
#include "batch/manifest_line.h"
#include "batch/schedule.h"
#include "batch/task.h"
#include "batch/work_folder.h"

namespace abflat::cli {

/// How many tasks run at once, and with what.
struct RunLimits {
  std::size_t jobs = 1;
  double memory = 0;  ///< MB for all that run at once
};

RunLimits runLimits(const BatchCommand& command);

/// Runs tasks, each as a process of its own, so that one that dies takes only its mesh with it.
class TaskRunner {
 public:
  /// Called with the line of each task that has ended; what it returns ends all others unless ok.
  using OnEnd = std::function<Status(const ManifestLine&)>;

  TaskRunner(const BatchCommand& command, std::vector<Task>& tasks, const WorkFolder& work);
  ~TaskRunner();
  TaskRunner(const TaskRunner&) = delete;
  TaskRunner& operator=(const TaskRunner&) = delete;

  /// Errors: CannotWrite, OutOfMemory; Aborted if a signal asks for that. Tasks that had not ended
  /// leave nothing then.
  Status run(const std::vector<std::size_t>& wanted, const OnEnd& onEnd);

 private:
  using Clock = std::chrono::steady_clock;
  struct Running {
    std::size_t task = 0;
    pid_t child = 0;
    WorkPlace place;
    Clock::time_point start;
    double timeLimit = 0;  ///< once it has been ended for that
  };

  struct Ended {
    Running was;
    ChildEnd child;
    double seconds = 0;
  };

  static double secondsSince(Clock::time_point start);
  Status startAll(Schedule& schedule);
  Status start(std::size_t task, bool isAlone);
  std::vector<std::string> wordsFor(const Task& task, const WorkPlace& place, bool isAlone) const;
  std::string placeOf(const std::string& output) const;
  Status writeParts(const Task& task, const WorkPlace& place) const;
  void reap();
  Status finishEnded(const OnEnd& onEnd, BatchProgress& progress);
  void endSlow();
  void endAll();

  const BatchCommand& command_;
  std::vector<Task>& tasks_;
  const WorkFolder& work_;
  const std::string program_;
  const RunLimits limits_;
  bool hasThreads_ = false;
  std::size_t threads_ = 1;  ///< of each task
  double usedMemory_ = 0;
  std::vector<Running> running_;
  std::vector<Ended> ended_;  ///< whose files are still where they were written
};

}  // namespace abflat::cli
