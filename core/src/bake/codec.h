#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "abflat/bake.h"

namespace abflat {

/// The nearest whole number of one that is not negative. lround is slower.
inline std::uint32_t nearestWhole(float value) {
  const float next = value + 0.5f;
  return static_cast<std::uint32_t>(next);
}

/// The numbers in an image and the linear values from 0 to 1 that they stand for.
class Codec {
 public:
  Codec(ColourSpace space, int bits);

  /// The value of each number.
  const std::vector<float>& values() const { return values_; }

  /// The nearest number, as encoded.
  std::uint32_t encode(float value) const {
    const float v = std::min(std::max(value, 0.0f), 1.0f);
    if (firstIn_.empty()) return nearestWhole(v * static_cast<float>(most_));
    std::uint32_t code = firstIn_[static_cast<std::size_t>(v * cells_)];
    while (code < most_ && v >= lower_[code + 1]) ++code;
    return code;
  }

 private:
  std::uint32_t most_;
  std::vector<float> values_;
  // Only of sRGB:
  std::vector<float> lower_;  ///< of the values whose nearest number it is
  float cells_ = 0;
  std::vector<std::uint32_t> firstIn_;  ///< the number of the least value in a cell of [0, 1]
};

}  // namespace abflat
