#pragma once

#include <cstdint>
#include <vector>

namespace abflat {

/// The pixels of the covered texels of a band that are next to one that is not: all that can be the
/// nearest covered texel of another.
class BorderPixels {
 public:
  BorderPixels() = default;
  BorderPixels(std::size_t width, std::size_t rows, std::size_t pixelBytes);

  void mark(std::size_t row, std::size_t x) { words_[row * stride_ + x / 64] |= bit(x); }
  /// Once all are marked, and before any pixel is asked for.
  void settle();

  bool isMarked(std::size_t row, std::size_t x) const {
    return (words_[row * stride_ + x / 64] & bit(x)) != 0;
  }
  std::uint8_t* pixel(std::size_t row, std::size_t x) {
    return pixels_.data() + pixelBytes_ * rank(row, x);
  }
  const std::uint8_t* pixel(std::size_t row, std::size_t x) const {
    return pixels_.data() + pixelBytes_ * rank(row, x);
  }

 private:
  static std::uint64_t bit(std::size_t x) { return std::uint64_t{1} << (x % 64); }
  /// How many are marked before this one.
  std::size_t rank(std::size_t row, std::size_t x) const;

  std::size_t stride_ = 0, pixelBytes_ = 0;
  std::vector<std::uint64_t> words_;
  std::vector<std::uint32_t> before_;  ///< marked before each word
  std::vector<std::uint8_t> pixels_;
};

}  // namespace abflat
