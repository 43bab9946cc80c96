#include "bake/border.h"

#include <bitset>

namespace abflat {
namespace {

std::size_t onesIn(std::uint64_t word) { return std::bitset<64>(word).count(); }

}  // namespace

BorderPixels::BorderPixels(std::size_t width, std::size_t rows, std::size_t pixelBytes)
    : stride_((width + 63) / 64), pixelBytes_(pixelBytes), words_(stride_ * rows) {}

void BorderPixels::settle() {
  std::size_t sum = 0;
  for (const std::uint64_t word : words_) {
    before_.push_back(static_cast<std::uint32_t>(sum));
    sum += onesIn(word);
  }
  pixels_.resize(sum * pixelBytes_);
}

std::size_t BorderPixels::rank(std::size_t row, std::size_t x) const {
  const std::size_t word = row * stride_ + x / 64;
  return before_[word] + onesIn(words_[word] & (bit(x) - 1));
}

}  // namespace abflat
