#pragma once

#include <cstdint>

#include "abflat/bake.h"
#include "bake/codec.h"
#include "bake/colour.h"

namespace abflat {

/// How the numbers of a texel become values.
struct Decoding {
  explicit Decoding(const Codec& codec)
      : values(codec.values().data()),
        alphaUnit(1 / static_cast<float>(codec.values().size() - 1)) {}

  const float* values;  ///< of colours, by number
  float alphaUnit;      ///< alpha per number
};

/// Texels of one kind in memory.
template <class T, int kCount, bool kIsOpacity>
struct TexelType {
  using Number = T;
  static constexpr int kChannels = kCount;
  static constexpr bool kHasAlpha = kCount == 2 || kCount == 4;
  /// Colours are multiplied by their opacity, which takes the place of alpha.
  static constexpr bool kIsWeighed = kIsOpacity && kHasAlpha;

  /// The colour of a texel, as it is added up.
  static Colour load(const Number* texel, const Decoding& decoding) {
    const float first = decoding.values[texel[0]];
    Colour c(first, first, first, 1);
    if constexpr (kCount > 2)
      c = Colour(first, decoding.values[texel[1]], decoding.values[texel[2]], 1);
    if constexpr (kHasAlpha) {
      const float alpha = static_cast<float>(texel[kCount - 1]) * decoding.alphaUnit;
      if constexpr (kIsWeighed) return c * (alpha + kLeastOpacity);
      c.v[3] = alpha;
    }
    return c;
  }
};

/// Writes a colour to a texel of an image with these channels.
template <class Number>
void store(const Colour& colour, const Codec& codec, int channels, Number* texel) {
  const bool hasAlpha = channels == 2 || channels == 4;
  const int colours = hasAlpha ? channels - 1 : channels;
  for (int d = 0; d < colours; ++d) texel[d] = static_cast<Number>(codec.encode(colour.v[d]));
  if (!hasAlpha) return;
  const float alpha = std::min(std::max(colour.v[3], 0.0f), 1.0f);
  const auto most = static_cast<float>(codec.values().size() - 1);
  texel[channels - 1] = static_cast<Number>(nearestWhole(alpha * most));
}

/// work(TexelType<...>()) for the texels of a texture.
template <class Work>
auto withTexelType(const BakeTexture& texture, const Work& work) {
  const auto ofNumber = [&](auto number) {
    using N = decltype(number);
    switch (texture.image.channels) {
      case 1:
        return work(TexelType<N, 1, false>());
      case 2:
        return texture.alphaIsOpacity ? work(TexelType<N, 2, true>())
                                      : work(TexelType<N, 2, false>());
      case 3:
        return work(TexelType<N, 3, false>());
      default:
        return texture.alphaIsOpacity ? work(TexelType<N, 4, true>())
                                      : work(TexelType<N, 4, false>());
    }
  };
  return texture.image.bits == 8 ? ofNumber(std::uint8_t{}) : ofNumber(std::uint16_t{});
}

}  // namespace abflat
