#pragma once

#include <string>
#include <string_view>

#include "abflat/status.h"

namespace abflat::cli {

/// A folder for results. It is created if it is missing; files with the same name are replaced,
/// others left alone.
class OutputFolder {
 public:
  explicit OutputFolder(std::string path) : path_(std::move(path)) {}

  /// Creates the folder and checks that files can be written there. Errors: CannotWrite.
  Status prepare() const;
  /// Errors: CannotWrite.
  Status write(const std::string& name, std::string_view bytes) const;

 private:
  std::string path_;
};

}  // namespace abflat::cli
