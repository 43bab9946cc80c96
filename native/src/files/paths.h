#pragma once

#include <string>

namespace abflat::cli {

/// Stands for standard input or standard output where a path is expected.
constexpr const char* kStandardStream = "-";

/// Extension of a file name with its dot, in lower case; empty if there is none.
std::string endingOf(const std::string& path);

bool isStandardOutput(const std::string& path);

/// Whether writing to both would mix or lose one of them: they are the same file under any name, or
/// both are standard output. Devices such as /dev/null take any number of writers.
bool isSameTarget(const std::string& a, const std::string& b);

/// How a path is named in messages.
std::string inputName(const std::string& path);
std::string outputName(const std::string& path);

}  // namespace abflat::cli
