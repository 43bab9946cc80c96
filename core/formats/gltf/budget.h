#pragma once

#include <algorithm>
#include <cstddef>

namespace abflat::gltf {

/// How many elements a file may produce from its bytes. Accessors, primitives and meshes may share
/// bytes, so a small file could ask for any number of vertices; honest files share bytes only a few
/// times.
class Budget {
 public:
  explicit Budget(std::size_t fileSize) : Budget(fileSize, kLeast, kPerByte) {}
  Budget(std::size_t fileSize, std::size_t least, std::size_t perByte)
      : left_(std::max(least, perByte * fileSize)) {}

  /// For files whose meshes are copied on request, as often as scenes place trees.
  static Budget ofCopies(std::size_t fileSize) {
    constexpr std::size_t kCopies = 64;
    return {fileSize, kCopies * kLeast, kCopies * kPerByte};
  }

  /// False if there is no room for this many more.
  bool take(std::size_t elements) {
    if (elements > left_) return false;
    left_ -= elements;
    return true;
  }

 private:
  static constexpr std::size_t kLeast = std::size_t{1} << 20, kPerByte = 8;

  std::size_t left_;
};

}  // namespace abflat::gltf
