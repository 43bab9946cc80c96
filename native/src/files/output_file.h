#pragma once

#include <string>
#include <vector>

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

  /// Whether writing there looks possible; to be asked before long work. Errors: CannotWrite.
  Status check() const;
  /// Puts the bytes on the disk under another name; those of a direct output wait until commit.
  /// Errors: CannotWrite.
  Status write(std::string bytes);

  /// Makes what was written to all of these visible, or none of it. Direct outputs come first, then
  /// files get their names one by one, and lose them again if one cannot have its own or the
  /// program is interrupted. Errors: CannotWrite.
  static Status commit(const std::vector<OutputFile*>& files);

  /// Writes and commits this file alone.
  Status writeNow(std::string bytes);

 private:
  Status failure(const std::string& reason) const;
  template <class Call>
  std::string withFreshName(const Call& call) const;
  int openTemporary();
  Status writeDirectly() const;
  Status keepOld();
  Status takeName();
  Status syncFolder() const;
  Status undo();
  void settle();
  static Status takeNames(const std::vector<OutputFile*>& files);

  std::string name_;       ///< as the user wrote it
  std::string target_;     ///< behind symbolic links
  std::string temporary_;  ///< empty if there is none
  std::string old_;        ///< the former target under another name; empty if there is none
  std::string bytes_;      ///< of a direct output
  bool isDirect_ = false, hasName_ = false;
  bool isOldInPlace_ = false;  ///< the old file also still has its own name
};

}  // namespace abflat::cli
