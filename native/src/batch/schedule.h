#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <vector>

#include "batch/task.h"

namespace abflat::cli {

/// Which task starts next: the largest that fits beside what runs, so that no large one is left for
/// the end. Tasks that never fit beside others come first, each alone.
class Schedule {
 public:
  /// `memory`: MB for all that run at once.
  Schedule(const std::vector<Task>& tasks, const std::vector<std::size_t>& wanted, double memory);

  bool isEmpty() const { return waiting_.empty(); }
  /// Takes a task that may start while others with this many MB in all run; none if it has to wait.
  std::optional<std::size_t> next(std::size_t running, double usedMemory);
  /// Whether a task runs alone.
  bool isAlone(std::size_t task) const { return tasks_[task].memory > memory_; }

 private:
  const std::vector<Task>& tasks_;
  const double memory_;
  std::deque<std::size_t> waiting_;  ///< largest first
};

}  // namespace abflat::cli
