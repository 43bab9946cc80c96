#include "files/file_format.h"

#include "files/paths.h"

namespace abflat::cli {
namespace {

bool isWritten(std::optional<FileFormat> format) {
  return format && precisionOf(*format) != Precision::None;
}

}  // namespace

std::optional<FileFormat> namedFormat(const std::string& path) {
  const std::string ending = endingOf(path);
  for (const FileEnding& known : kFileEndings)
    if (ending == known.ending) return known.format;
  return {};
}

bool isWritableName(const std::string& path) {
  return endingOf(path).empty() || isWritten(namedFormat(path));
}

FileFormat writtenFormat(const std::string& path) {
  const std::optional<FileFormat> named = namedFormat(path);
  return isWritten(named) ? *named : kUnnamedFormat;
}

std::optional<MeshFormat> coreFormat(FileFormat format) {
  const int number = static_cast<int>(format);
  if (number >= kMeshFormatCount) return {};
  return static_cast<MeshFormat>(number);
}

}  // namespace abflat::cli
