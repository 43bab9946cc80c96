#pragma once

#include <map>
#include <string>
#include <vector>

#include "abflat/appearance.h"

namespace abflat {

enum class ImageTypes { OfGltf, All };

/// Images that materials name, each read once.
class Images {
 public:
  Images(const ReadResource& readResource, ImageTypes types, std::vector<ImageFile>& out,
         std::vector<std::string>& notes)
      : readResource_(readResource), types_(types), out_(out), notes_(notes) {}

  /// Index of the image with this path, as written by a file from any system, relative to `folder`
  /// ("" or ending in a slash). If the image cannot be used, returns kNoImage and adds a note.
  std::size_t numberOf(const std::string& folder, std::string path);

 private:
  std::size_t read(const std::string& folder, const std::string& path);

  const ReadResource& readResource_;
  ImageTypes types_;
  std::vector<ImageFile>& out_;
  std::vector<std::string>& notes_;
  std::map<std::string, std::size_t> numbers_;  ///< by path
};

/// The part of a path up to and including its last slash.
std::string folderOf(const std::string& path);

}  // namespace abflat
