#pragma once

#include <sys/types.h>

#include <optional>
#include <string>
#include <vector>

namespace abflat::cli {

/// How a program is started.
struct ChildStart {
  std::string program;             ///< path
  std::vector<std::string> words;  ///< its name and arguments
  std::string said;                ///< file for what it prints
  double memoryLimit = 0;          ///< MB of address space; 0: none
};

/// How a program ended.
struct ChildEnd {
  int exitCode = 0;  ///< if there is no signal
  int signal = 0;
  double peakMemory = 0;  ///< MB
};

/// The path of this program; empty if the system does not tell.
std::string ownProgram();

/// Starts a program that ends when this one does. Returns -1 and sets errno on failure. Signals
/// that this program holds back are delivered there.
pid_t startChild(const ChildStart& start);

/// How a child ended; none while it runs.
std::optional<ChildEnd> endOf(pid_t child);

}  // namespace abflat::cli
