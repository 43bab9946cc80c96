#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "abflat/bake.h"
#include "abflat/generated/bake_options.h"
#include "abflat/status.h"

namespace abflat::images {

/// An image in memory. What the numbers stand for, the file does not say: profiles and gamma are
/// left alone, as glTF wants it.
struct Image {
  std::uint32_t width = 0, height = 0;
  int channels = 4, bits = 8;        ///< as in ImageView
  std::vector<std::uint8_t> pixels;  ///< in rows from the top; 16-bit ones as the machine has them

  ImageView view() const { return {pixels.data(), width, height, channels, bits}; }
};

/// What an image may have at most, so that a few bytes cannot ask for all of the memory.
constexpr std::uint32_t kMostSide = kMostBakedTexels;
constexpr std::uint64_t kMostPixels = std::uint64_t{1} << 28;

struct Size {
  std::uint32_t width = 0, height = 0;

  std::uint64_t pixels() const { return std::uint64_t{width} * height; }
};

/// The size of a PNG, JPEG or WebP file that readImage reads, unless it is damaged further on.
Result<Size> imageSize(std::string_view bytes, const std::string& name);

/// A PNG, JPEG or WebP file. `name` is for messages. Errors: ParseError, OutOfMemory.
Result<Image> readImage(std::string_view bytes, const std::string& name);

const char* mimeTypeOf(ImageFormat format);
/// Of its files, with a dot.
const char* endingOf(ImageFormat format);

/// The file of an image; only a PNG takes 16 bits. JPEG has no alpha, so it takes 1 or 3 channels.
/// `quality` is from 1 to 100; with 100, WebP loses nothing. Errors: CannotWrite, OutOfMemory.
Result<std::string> writeImage(const Image& image, ImageFormat format, int quality);

}  // namespace abflat::images
