#include "batch/glob.h"

#include <fnmatch.h>

#include <algorithm>
#include <filesystem>

namespace abflat::cli {
namespace {

namespace fs = std::filesystem;

class Matches {
 public:
  explicit Matches(const fs::path& pattern) : parts_(pattern.begin(), pattern.end()) {}

  std::vector<std::string> find() {
    follow({}, 0);
    std::sort(found_.begin(), found_.end());
    found_.erase(std::unique(found_.begin(), found_.end()), found_.end());
    return std::move(found_);
  }

 private:
  /// Below `folder`, which matches the parts before `part`.
  void follow(const fs::path& folder, std::size_t part) {
    std::error_code ignored;  // what cannot be looked up does not match
    if (part == parts_.size()) {
      if (fs::is_regular_file(folder, ignored)) found_.push_back(folder.string());
      return;
    }
    const std::string name = parts_[part].string();
    if (!isPattern(name)) {
      if (fs::exists(folder / name, ignored)) follow(folder / name, part + 1);
      return;
    }
    const bool isDeep = name == "**";
    if (isDeep) follow(folder, part + 1);
    const fs::path listed = folder.empty() ? fs::path(".") : folder;
    for (const fs::directory_entry& entry : fs::directory_iterator(listed, ignored)) {
      const fs::path child = folder / entry.path().filename();
      if (fnmatch(isDeep ? "*" : name.c_str(), child.filename().c_str(), FNM_PERIOD) != 0) continue;
      const bool goesDown = isDeep && entry.is_directory(ignored) && !entry.is_symlink(ignored);
      if (goesDown) follow(child, part);
      if (!isDeep) follow(child, part + 1);
    }
  }

  std::vector<fs::path> parts_;
  std::vector<std::string> found_;
};

}  // namespace

bool isPattern(const std::string& path) { return path.find_first_of("*?[") != std::string::npos; }

std::vector<std::string> filesLike(const std::string& pattern) { return Matches(pattern).find(); }

}  // namespace abflat::cli
