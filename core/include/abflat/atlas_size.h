#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include "abflat/export.h"

namespace abflat {

/// The size of a texture in texels, which are square: u = 1 is at `width`, v = 1 at `height`. A
/// number alone is the side of a square.
struct AtlasSize {
  int width = 0, height = 0;

  constexpr AtlasSize() = default;
  // NOLINTNEXTLINE(google-explicit-constructor): options.resolution = 2048
  constexpr AtlasSize(int side) : width(side), height(side) {}
  constexpr AtlasSize(int across, int up) : width(across), height(up) {}

  constexpr bool operator==(const AtlasSize& o) const {
    return width == o.width && height == o.height;
  }
  constexpr bool operator!=(const AtlasSize& o) const { return !(*this == o); }
  constexpr bool isSquare() const { return width == height; }
  constexpr int longer() const { return std::max(width, height); }
  constexpr int shorter() const { return std::min(width, height); }
  /// The side of a square with as many texels.
  double meanSide() const { return std::sqrt(static_cast<double>(width) * height); }
  /// A length that is 1 in u where it lies along u is this much in v where it lies along v.
  double aspect() const { return static_cast<double>(width) / height; }
};

/// "1024" for a square, otherwise "2048 x 1024".
inline std::string atlasSizeText(const AtlasSize& size) {
  const std::string width = std::to_string(size.width);
  return size.isSquare() ? width : width + " x " + std::to_string(size.height);
}

/// As setOption() takes a size that is not that of a square: width + height * this.
constexpr double kHeightUnit = 65536;

/// The number for a text such as "2048x1024". `found`: it has two parts; if these are no whole
/// numbers that fit, the number is one that setOption() refuses.
ABFLAT_API double atlasSizeValue(std::string_view text, bool& found);

/// The inverse: 0 x 0 if that is no size. `mayBePair`: as in setOption(), which names it `isWord`.
inline AtlasSize atlasSize(double value, bool mayBePair) {
  constexpr double kMost = kHeightUnit * kHeightUnit;
  if (!(value >= 0 && value < (mayBePair ? kMost : kHeightUnit)) || value != std::floor(value))
    return {};
  const double height = std::floor(value / kHeightUnit);
  const auto width = static_cast<int>(value - height * kHeightUnit);
  return {width, height > 0 ? static_cast<int>(height) : width};
}

}  // namespace abflat
