#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "abflat/appearance.h"
#include "images/image.h"

namespace abflat::cli {

/// The images of a file, in the forms that materials need. They are decoded when they are needed.
class OldImages {
 public:
  /// Takes the bytes of the files. Errors: those of imageSize, and too many pixels in all.
  Status take(std::vector<ImageFile>& files);

  std::size_t count() const { return files_.size(); }
  images::Size size(std::size_t image) const { return sizes_[image]; }

  // Views are valid until `release`. Errors: those of readImage.
  Result<ImageView> whole(std::size_t image);
  /// Without alpha, for materials to which it means nothing.
  Result<ImageView> opaque(std::size_t image);
  /// Red alone, as 1 - strength * (1 - red): ambient occlusion of some strength.
  Result<ImageView> occlusion(std::size_t image, double strength);

  /// Those decoded so far that have 16 bits per channel.
  const std::set<std::size_t>& deep() const { return deep_; }

  /// Frees what was decoded.
  void release();

 private:
  std::vector<ImageFile> files_;
  std::vector<images::Size> sizes_;
  std::set<std::size_t> deep_;
  std::map<std::size_t, images::Image> whole_, opaque_;
  std::map<std::pair<std::size_t, double>, images::Image> occlusion_;
};

/// Says that so many images lose bits of their channels; empty for none.
std::string depthNote(std::size_t count);

}  // namespace abflat::cli
