#pragma once

#include <cstdint>
#include <vector>

#include "abflat/bake.h"
#include "bake/codec.h"

namespace abflat {

/// A texture at ever smaller sizes: each level has half as many texels a side as the one before,
/// rounded down. They keep the channels and bits of the texture.
struct Pyramid {
  struct Level {
    std::uint32_t width = 0, height = 0;
    std::vector<std::uint16_t> storage;  ///< of its pixels, whatever their size
    const void* pixels = nullptr;
  };
  std::vector<Level> levels;  ///< the first is the image of the caller
};

/// Each texel is the mean of the area it covers, in linear light. All levels are computed from what
/// is not rounded yet.
Pyramid makePyramid(const BakeTexture& texture, const Codec& codec, int reductions);

/// How often an image of this size can be halved.
int mostReductions(const ImageView& image);

}  // namespace abflat
