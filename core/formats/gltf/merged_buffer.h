#pragma once

#include <string>
#include <vector>

#include "gltf/document.h"

namespace abflat::gltf {

/// All buffers of a file joined into one, without the bytes that no view holds or only dropped
/// views hold. Every byte keeps its alignment.
class MergedBuffer {
 public:
  /// `isLeft`: per view, whether it is dropped.
  MergedBuffer(const Document& document, const std::vector<bool>& isLeft);

  /// Where the bytes of a view that is not dropped are now.
  std::size_t offsetOf(const BufferView& view) const;

  /// Appends bytes at a multiple of 4. Returns their offset.
  std::size_t append(const std::string& bytes);

  const std::string& bytes() const { return bytes_; }
  std::string take() { return std::move(bytes_); }

 private:
  struct Range {
    std::size_t begin, end, newBegin;
  };

  void align(std::size_t alignment, std::size_t remainder);

  std::vector<std::vector<Range>> kept_;  ///< by buffer, ascending
  std::string bytes_;
};

}  // namespace abflat::gltf
