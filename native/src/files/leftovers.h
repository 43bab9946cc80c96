#pragma once

#include <string>

namespace abflat::cli {

/// While it lives, signals that end the program wait: a file cannot exist without being watched,
/// and files get their names together. Threads too are held.
class SignalPause {
 public:
  SignalPause();
  ~SignalPause();  ///< ends the program if a signal has come
  SignalPause(const SignalPause&) = delete;
  SignalPause& operator=(const SignalPause&) = delete;

  /// Whether one is waiting.
  bool hasSignal() const;
};

/// Sees to it that a file does not outlive the program when it is interrupted (SIGINT, SIGTERM,
/// SIGHUP, SIGQUIT, SIGXCPU).
void removeOnSignal(const std::string& path);
/// The file is no longer to be removed. No effect for other paths.
void keepOnSignal(const std::string& path);

}  // namespace abflat::cli
