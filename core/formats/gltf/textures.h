#pragma once

#include <string>
#include <vector>

#include "abflat/gltf_look.h"
#include "gltf/document.h"

namespace abflat::gltf {

/// Reads the uses of textures, and each image that they need once.
class TextureReader {
 public:
  TextureReader(const Document& document, const ReadResource& readResource, Complaints& complaints);

  /// `info`: a texture of a material, which may be absent.
  GltfTexture read(const Field& info);

  std::vector<ImageFile> takeImages() { return std::move(images_); }

 private:
  std::size_t imageOf(const Field& texture);
  ImageFile load(std::size_t image) const;
  void setWrap(const Field& texture, GltfTexture& out) const;

  const Document& document_;
  const ReadResource& readResource_;
  Complaints& complaints_;
  Field root_;
  std::vector<std::size_t> numbers_;  ///< by image of the file: its number in images_, or kNone
  std::vector<ImageFile> images_;
};

}  // namespace abflat::gltf
