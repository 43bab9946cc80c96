#include "files/files_beside.h"

#include <filesystem>
#include <utility>

#include "files/paths.h"

namespace abflat::cli {

namespace fs = std::filesystem;

FilesBeside::FilesBeside(const std::string& output)
    : output_(output), stem_(fs::path(output).stem().string()) {}

std::string FilesBeside::pathOf(const std::string& name) const {
  return (fs::path(output_).parent_path() / name).string();
}

Status FilesBeside::check(const std::vector<std::string>& names,
                          const std::vector<std::string>& used) const {
  for (const std::string& name : names) {
    const std::string path = pathOf(name);
    if (Status s = OutputFile(path).check(); !s.ok()) return s;
    for (const std::string& other : used)
      if (isSameTarget(path, other))
        return {StatusCode::InvalidOption,
                "--bake would write " + path + ", which is in use. Give --output another name"};
  }
  return {};
}

Status FilesBeside::write(std::vector<ImageFile> contents, std::vector<OutputFile*>& files) {
  for (ImageFile& content : contents) {
    OutputFile& file = files_.emplace_back(pathOf(content.name));
    if (Status s = file.write(std::move(content.bytes)); !s.ok()) return s;
    files.push_back(&file);
  }
  return {};
}

}  // namespace abflat::cli
