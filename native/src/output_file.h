#pragma once

#include <string>
#include <string_view>

#include "abflat/status.h"

namespace abflat::cli {

/// A file that appears completely or not at all: written under a temporary name in the folder of
/// its target, then renamed. Standard output, devices and pipes are written directly.
class OutputFile {
 public:
  explicit OutputFile(const std::string& path);  ///< "-" is standard output; nothing is opened yet
  ~OutputFile();                                 ///< removes what was not committed
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Whether it looks possible to write there: asked before long work. Errors: CannotWrite.
  Status check() const;
  /// Errors: CannotWrite.
  Status write(std::string_view bytes);
  /// Makes what was written visible under its name. Errors: CannotWrite.
  Status commit();

 private:
  Status failure(const std::string& reason) const;
  Status writeDirectly(std::string_view bytes) const;
  int openTemporary();

  std::string name_;       ///< as the user wrote it
  std::string target_;     ///< behind symbolic links
  std::string temporary_;  ///< empty when there is none
  bool isDirect_ = false;
};

}  // namespace abflat::cli
