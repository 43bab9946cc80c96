#include "files/paths.h"

#include <filesystem>

namespace abflat::cli {

namespace fs = std::filesystem;

std::string endingOf(const std::string& path) {
  std::string ending = fs::path(path).extension().string();
  for (char& c : ending)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return ending;
}

bool isStandardOutput(const std::string& path) {
  return path == kStandardStream || path == "/dev/stdout";
}

bool isSameTarget(const std::string& a, const std::string& b) {
  if (isStandardOutput(a) || isStandardOutput(b)) return isStandardOutput(a) && isStandardOutput(b);
  std::error_code ignored;  // a name that cannot be looked up is compared as written
  if (fs::is_other(a, ignored)) return false;
  if (fs::exists(a, ignored) && fs::exists(b, ignored)) return fs::equivalent(a, b, ignored);
  return fs::weakly_canonical(fs::absolute(a, ignored), ignored) ==
         fs::weakly_canonical(fs::absolute(b, ignored), ignored);
}

std::string inputName(const std::string& path) {
  return path == kStandardStream ? "standard input" : path;
}

std::string outputName(const std::string& path) {
  return path == kStandardStream ? "standard output" : path;
}

}  // namespace abflat::cli
