#pragma once

#include <csignal>
#include <string>

namespace abflat::cli {

/// While it lives, signals that end the program wait: a file cannot exist without being watched.
class SignalPause {
 public:
  SignalPause();
  ~SignalPause();
  SignalPause(const SignalPause&) = delete;
  SignalPause& operator=(const SignalPause&) = delete;

 private:
  sigset_t before_{};
};

/// Sees to it that a file does not outlive the program when it is interrupted (SIGINT, SIGTERM,
/// SIGHUP).
void removeOnSignal(const std::string& path);
/// The file is no longer to be removed. No effect for other paths.
void keepOnSignal(const std::string& path);

}  // namespace abflat::cli
