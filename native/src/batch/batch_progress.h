#pragma once

#include <chrono>
#include <cstddef>
#include <string>

#include "batch/task.h"

namespace abflat::cli {

/// "2 h 5 min", "3 min 4 s", "5 s".
std::string durationText(double seconds);

/// A line on the terminal: how many meshes are done, how fast, and how long the others will take.
class BatchProgress {
 public:
  BatchProgress(bool isEnabled, std::size_t count, double work)
      : isEnabled_(isEnabled), count_(count), work_(work) {}
  ~BatchProgress() { clear(); }
  BatchProgress(const BatchProgress&) = delete;
  BatchProgress& operator=(const BatchProgress&) = delete;

  /// What a task takes, relative to others.
  static double workOf(const Task& task);

  void add(const Task& task, bool isGood);
  void show(std::size_t running);
  void clear();

 private:
  using Clock = std::chrono::steady_clock;

  double seconds() const;

  const bool isEnabled_;
  const std::size_t count_;
  const double work_;
  const Clock::time_point start_ = Clock::now();
  std::size_t done_ = 0, failed_ = 0;
  double workDone_ = 0;
  bool isShown_ = false;
};

}  // namespace abflat::cli
