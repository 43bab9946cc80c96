#pragma once

#include <cstddef>
#include <functional>
#include <utility>

namespace abflat {

/// Notifies a caller now and then during a long loop, and lets it stop the loop.
class Pulse {
 public:
  /// A pulse without a listener.
  Pulse() = default;
  /// `goesOn` is called repeatedly until it returns false.
  explicit Pulse(std::function<bool()> goesOn) : goesOn_(std::move(goesOn)) {}

  /// To be called after `steps` small steps of work; returns whether to continue. A result that is
  /// returned early may be incomplete, but is consistent.
  bool beat(std::size_t steps = 1) const {
    done_ += steps;
    if (done_ < kSteps) return !isStopped_;
    done_ = 0;
    return ask();
  }
  /// Asks at once whether to continue.
  bool ask() const {
    isStopped_ = isStopped_ || (goesOn_ && !goesOn_());
    return !isStopped_;
  }
  bool isStopped() const { return isStopped_; }

  /// It asks after this many steps, which is some milliseconds.
  static constexpr std::size_t kSteps = 1 << 15;

 private:
  std::function<bool()> goesOn_;
  mutable std::size_t done_ = 0;  ///< since it last asked
  mutable bool isStopped_ = false;
};

}  // namespace abflat
