#pragma once

#include <string>

namespace abflat::cli {

/// While it exists, signals that would end the program wait. So no file exists without being
/// watched, and files get their names together. Other threads that pause signals wait, too.
class SignalPause {
 public:
  SignalPause();
  ~SignalPause();  ///< ends the program if a signal has come
  SignalPause(const SignalPause&) = delete;
  SignalPause& operator=(const SignalPause&) = delete;

  /// Whether a signal is waiting.
  bool hasSignal() const;
};

/// Makes sure that a file does not outlive the program if it is interrupted (SIGINT, SIGTERM,
/// SIGHUP, SIGQUIT, SIGXCPU).
void removeOnSignal(const std::string& path);
/// Stops watching the file. No effect for other paths.
void keepOnSignal(const std::string& path);

}  // namespace abflat::cli
