#include "batch/find_inputs.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "batch/glob.h"
#include "batch/list_file.h"
#include "files/file_format.h"
#include "files/paths.h"

namespace abflat::cli {
namespace {

namespace fs = std::filesystem;

fs::path realPath(const fs::path& path) {
  std::error_code ignored;  // a path that cannot be looked up stays as written
  const fs::path absolute = fs::absolute(path, ignored);
  const fs::path out = fs::weakly_canonical(absolute, ignored);
  return out.empty() ? absolute : out;
}

bool isBelow(const fs::path& folder, const fs::path& file) {
  return std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first ==
         folder.end();
}

bool isUtf8(const std::string& text) {
  using nlohmann::json;
  const std::string written = json(text).dump(-1, ' ', false, json::error_handler_t::replace);
  return json::parse(written, nullptr, false) == text;
}

bool isHidden(const fs::path& path) { return path.filename().string().front() == '.'; }

/// The name of the atlas that all meshes of a folder share.
std::string atlasOfFolder(const std::string& name) {
  return (fs::path(name).parent_path() / "atlas").generic_string();
}

class InputFinder {
 public:
  explicit InputFinder(const BatchCommand& command)
      : command_(command), known_(optionsOfCommand(command.run)), out_(realPath(command.out)) {}

  Result<std::vector<BatchInput>> find() {
    for (const std::string& path : command_.inputs)
      if (Status s = path == kStandardStream ? addList(path) : addNamed(path); !s.ok()) return s;
    for (const std::string& path : command_.lists)
      if (Status s = addList(path); !s.ok()) return s;
    return eachOnce();
  }

 private:
  Status addList(const std::string& path) {
    Result<std::vector<BatchInput>> listed = readList(path, known_);
    if (!listed.ok()) return listed.status();
    std::move(listed.value().begin(), listed.value().end(), std::back_inserter(found_));
    return {};
  }

  Status addNamed(const std::string& path) {
    std::error_code ignored;  // what cannot be looked up does not exist
    if (fs::is_directory(path, ignored)) return addFolder(path);
    if (fs::exists(path, ignored)) {
      found_.push_back({path, nameBelow(path), {}, {}, false});
      return {};
    }
    if (!isPattern(path)) return {StatusCode::UnreadableFile, "there is no file " + path};
    const std::vector<std::string> files = filesLike(path);
    for (const std::string& file : files)
      if (!isBelow(out_, realPath(file))) found_.push_back({file, nameBelow(file), {}, {}, false});
    if (files.empty()) return {StatusCode::UnreadableFile, "no file is like " + path};
    return {};
  }

  Status addFolder(const fs::path& folder) {
    const std::size_t before = found_.size();
    std::error_code error;
    auto entry = fs::recursive_directory_iterator(folder, error);
    for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
      const fs::path path = entry->path();
      std::error_code ignored;  // what cannot be looked up is no file
      if (isHidden(path) || (entry->is_directory(ignored) && isBelow(out_, realPath(path))))
        entry.disable_recursion_pending();
      else if (entry->is_regular_file(ignored) && namedFormat(path.string()))
        found_.push_back(
            {path.string(), path.lexically_relative(folder).generic_string(), {}, {}, false});
    }
    if (error)
      return {StatusCode::UnreadableFile,
              "cannot read the folder " + folder.string() + ": " + error.message()};
    if (found_.size() == before)
      return {StatusCode::UnreadableFile, "there is no mesh in the folder " + folder.string() +
                                              ". Files of " + kFormatTitles + " are looked for"};
    return {};
  }

  /// A file may be named in several ways.
  Result<std::vector<BatchInput>> eachOnce() {
    std::map<fs::path, BatchInput> files;
    for (BatchInput& input : found_) {
      const fs::path path = realPath(input.path);
      if (isBelow(out_, path))
        return Status{StatusCode::InvalidOption,
                      input.path + " lies where the results go. Give --out another folder"};
      if (!isUtf8(input.name) || !isUtf8(input.atlas))
        return Status{StatusCode::InvalidOption,
                      input.path + (isUtf8(input.name) ? " has an atlas with" : " has") +
                          " a name that is not UTF-8, so no manifest can hold it. "
                          "Rename it"};
      const auto [old, isNew] = files.try_emplace(path, input);
      if (isNew) continue;
      if (!hasSameOptions(old->second, input))
        return Status{StatusCode::InvalidOption,
                      input.path + " is named twice, with different options"};
      if (old->second.atlas != input.atlas)
        return Status{StatusCode::InvalidOption, input.path + " is named for two atlases"};
      if (input.name < old->second.name) old->second = input;
    }
    std::vector<BatchInput> out;
    out.reserve(files.size());
    for (auto& [path, input] : files) {
      if (command_.hasFolderAtlases && input.atlas.empty()) input.atlas = atlasOfFolder(input.name);
      out.push_back(std::move(input));
    }
    std::sort(out.begin(), out.end(),
              [](const BatchInput& a, const BatchInput& b) { return a.name < b.name; });
    return out;
  }

  const BatchCommand& command_;
  const std::vector<OptionOfCommand> known_;
  const fs::path out_;
  std::vector<BatchInput> found_;
};

}  // namespace

std::string nameBelow(const std::string& path) {
  fs::path out;
  for (const fs::path& part : fs::path(path).lexically_normal().relative_path())
    if (part != "..") out /= part;
  return out.generic_string();
}

bool hasSameOptions(const BatchInput& a, const BatchInput& b) {
  return std::equal(a.options.begin(), a.options.end(), b.options.begin(), b.options.end(),
                    [](const GivenOption& x, const GivenOption& y) {
                      return x.flag == y.flag && x.value == y.value;
                    });
}

Result<std::vector<BatchInput>> findInputs(const BatchCommand& command) {
  return InputFinder(command).find();
}

}  // namespace abflat::cli
