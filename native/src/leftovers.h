#pragma once

#include <string>

namespace abflat::cli {

/// Sees to it that a file does not outlive the program when it is interrupted (SIGINT, SIGTERM,
/// SIGHUP).
void removeOnSignal(const std::string& path);
/// The file is no longer to be removed. No effect for other paths.
void keepOnSignal(const std::string& path);

}  // namespace abflat::cli
