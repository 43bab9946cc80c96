#include "batch/schedule.h"

#include <algorithm>

namespace abflat::cli {

Schedule::Schedule(const std::vector<Task>& tasks, const std::vector<std::size_t>& wanted,
                   double memory)
    : tasks_(tasks), memory_(memory), waiting_(wanted.begin(), wanted.end()) {
  std::stable_sort(waiting_.begin(), waiting_.end(),
                   [&](std::size_t a, std::size_t b) { return tasks[a].memory > tasks[b].memory; });
}

std::optional<std::size_t> Schedule::next(std::size_t running, double usedMemory) {
  const auto fits = [&](std::size_t task) {
    return running == 0 || usedMemory + tasks_[task].memory <= memory_;
  };
  // Tasks are sorted by what they need, so the first that fits is found by halving.
  const auto found = std::partition_point(waiting_.begin(), waiting_.end(),
                                          [&](std::size_t task) { return !fits(task); });
  if (found == waiting_.end()) return {};
  const std::size_t out = *found;
  waiting_.erase(found);
  return out;
}

}  // namespace abflat::cli
