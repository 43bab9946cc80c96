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

  /// Number of the image with this path, as a file of some system writes it, relative to `folder`
  /// ("" or ending in a slash). One that cannot be used is kNoImage, and a note.
  std::size_t numberOf(const std::string& folder, std::string path);

 private:
  std::size_t read(const std::string& folder, const std::string& path);

  const ReadResource& readResource_;
  Appearance& out_;
  std::map<std::string, std::size_t> numbers_;  ///< by path
};

/// What stands before the last slash of a path, with it.
std::string folderOf(const std::string& path);

}  // namespace abflat
