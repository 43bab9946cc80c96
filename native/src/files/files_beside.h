#pragma once

#include <deque>
#include <string>
#include <vector>

#include "abflat/appearance.h"
#include "files/output_file.h"

namespace abflat::cli {

/// Files in the folder of another one, with names that begin as its own.
class FilesBeside {
 public:
  explicit FilesBeside(const std::string& output);

  const std::string& stem() const { return stem_; }
  /// Whether these can be written, and none of them is a path in `used`. Errors: InvalidOption,
  /// CannotWrite.
  Status check(const std::vector<std::string>& names, const std::vector<std::string>& used) const;
  /// Puts them on the disk under other names, and adds them to what is to be committed.
  Status write(std::vector<ImageFile> contents, std::vector<OutputFile*>& files);

 private:
  std::string pathOf(const std::string& name) const;

  std::string output_, stem_;
  std::deque<OutputFile> files_;
};

}  // namespace abflat::cli
