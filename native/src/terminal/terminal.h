#pragma once

#include <string>

#include "abflat/flatten.h"

namespace abflat::cli {

/// Removes what a terminal would interpret as a command: names and words of a file may contain
/// anything.
std::string printable(const std::string& text);

/// `message` with a full stop, unless it already ends a sentence.
std::string sentence(const std::string& message);

/// Prints "abflat: MESSAGE." on standard error, in one line.
void complain(const std::string& message);

bool isErrorTerminal();

/// One line on standard error that is overwritten again and again, and cleared at the end. Does
/// nothing if it is not enabled.
class ProgressLine {
 public:
  explicit ProgressLine(bool isEnabled) : isEnabled_(isEnabled) {}
  ~ProgressLine() { clear(); }
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void show(const Progress& progress);
  void clear();

 private:
  bool isEnabled_;
  bool isShown_ = false;
};

}  // namespace abflat::cli
