#pragma once

#include <map>
#include <string>

#include "abflat/appearance.h"

namespace abflat {

/// Images that materials name, each read once.
class Images {
 public:
  Images(const ReadResource& readResource, Appearance& out)
      : readResource_(readResource), out_(out) {}

  /// Index of the image with this path, as written by a file from any system, relative to `folder`
  /// ("" or ending in a slash). If the image cannot be used, returns kNoImage and adds a note.
  std::size_t numberOf(const std::string& folder, std::string path);

 private:
  std::size_t read(const std::string& folder, const std::string& path);

  const ReadResource& readResource_;
  Appearance& out_;
  std::map<std::string, std::size_t> numbers_;  ///< by path
};

/// The part of a path up to and including its last slash.
std::string folderOf(const std::string& path);

}  // namespace abflat
