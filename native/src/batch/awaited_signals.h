#pragma once

#include <csignal>

namespace abflat::cli {

/// While it exists, signals that end the program, and those of children, come only while waiting.
class AwaitedSignals {
 public:
  AwaitedSignals();
  ~AwaitedSignals();
  AwaitedSignals(const AwaitedSignals&) = delete;
  AwaitedSignals& operator=(const AwaitedSignals&) = delete;

  /// Until a signal comes, or for some seconds.
  void wait(double seconds) const;
  /// The signal that asks the program to end; 0 if none has come.
  static int asked();

 private:
  sigset_t before_{};
};

}  // namespace abflat::cli
