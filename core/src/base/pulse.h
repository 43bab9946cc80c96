#pragma once

#include <cstddef>
#include <functional>
#include <utility>

namespace abflat {

/// Lets a caller hear of a long loop now and then, and end it.
class Pulse {
 public:
  /// Nobody listens.
  Pulse() = default;
  /// `goesOn` is asked again and again until it says false.
  explicit Pulse(std::function<bool()> goesOn) : goesOn_(std::move(goesOn)) {}

  /// After `steps` small steps of work: whether there is to be more. What is returned early need
  /// not be complete, but holds together.
  bool beat(std::size_t steps = 1) const {
    done_ += steps;
    if (done_ < kSteps) return !isStopped_;
    done_ = 0;
    isStopped_ = isStopped_ || (goesOn_ && !goesOn_());
    return !isStopped_;
  }
  bool isStopped() const { return isStopped_; }

  /// After so many it asks: some milliseconds.
  static constexpr std::size_t kSteps = 1 << 15;

 private:
  std::function<bool()> goesOn_;
  mutable std::size_t done_ = 0;  ///< since it was last asked
  mutable bool isStopped_ = false;
};

}  // namespace abflat
