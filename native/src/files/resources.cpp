#include "files/resources.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>

#include "files/read_file.h"

namespace abflat::cli {
namespace {

namespace fs = std::filesystem;

/// How often a file may be read under different names, such as "a.png" and "./a.png". Otherwise a
/// short list of names could blow up the result to any size.
constexpr int kMostReads = 8;

bool isWithin(const fs::path& folder, const fs::path& file) {
  return std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first ==
         folder.end();
}

class Resources {
 public:
  Resources(const std::string& path, bool allowsOutside)
      : folder_(fs::path(path).parent_path()), allowsOutside_(allowsOutside) {}

  Result<std::string> read(const std::string& name) {
    const std::string shown = (folder_ / name.c_str()).string();
    const auto failure = [&](const std::string& reason) {
      return Status{StatusCode::UnreadableFile, "cannot read " + shown + ": " + reason};
    };
    if (name.find('\0') != std::string::npos) return failure("the name contains a zero byte");
    std::error_code error;
    const fs::path folder = fs::canonical(folder_.empty() ? "." : folder_, error);
    if (error) return failure(error.message());
    const fs::path file = fs::canonical(folder_ / name, error);
    if (!allowsOutside_ && isOutside(folder, file, name))
      return failure("it is outside the folder of the mesh. Use --allow-outside to read it");
    if (error) return failure(error.message());
    if (++reads_[file] > kMostReads)
      return failure("the mesh refers to it more than " + std::to_string(kMostReads) + " times");
    std::string bytes;
    if (const std::string s = readOrdinaryFile(file.string(), bytes); !s.empty()) return failure(s);
    return bytes;
  }

 private:
  /// A file that does not exist is judged by its name, so that a mesh cannot find out which files
  /// exist.
  bool isOutside(const fs::path& folder, const fs::path& file, const std::string& name) const {
    if (!file.empty()) return !isWithin(folder, file);
    std::error_code ignored;  // then it is judged by what is known of it
    return !isWithin(folder, fs::weakly_canonical(fs::absolute(folder_ / name, ignored), ignored));
  }

  fs::path folder_;
  bool allowsOutside_;
  std::map<fs::path, int> reads_;
};

}  // namespace

ReadResource resourcesOf(const std::string& path, bool allowsOutside) {
  const auto resources = std::make_shared<Resources>(path, allowsOutside);
  return [resources](const std::string& name) { return resources->read(name); };
}

}  // namespace abflat::cli
