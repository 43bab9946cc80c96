// Generated from core/schema by scripts/generate.mjs, do not edit.
// clang-format off
#pragma once

#include <cmath>
#include <limits>
#include <string_view>

#include "abflat/atlas_size.h"
#include "abflat/generated/pack_options.h"

namespace abflat {

/// Format of the new images.
enum class ImageFormat : int {
  Png = 0,  ///< without loss
  Jpeg = 1,  ///< smaller, with loss; an image with alpha becomes a PNG
  Webp = 2,  ///< smaller still; programs need EXT_texture_webp
};

inline const char* nameOf(ImageFormat code) {
  switch (code) {
    case ImageFormat::Png:
      return "png";
    case ImageFormat::Jpeg:
      return "jpeg";
    case ImageFormat::Webp:
      return "webp";
  }
  return "";
}

/// "auto" as a value of the option bakeResolution.
constexpr AtlasSize kAutoBakeResolution = 0;

/// The options of baking that are plain values, with their defaults.
struct BakeOptionValues {
  /// size of the new images in texels; of a number, the longer side of an image in the shape of the layout (auto = for each map the power of two that is nearest to the texels of the old images, or that of the layout if there are none)
  AtlasSize bakeResolution = 0;
  /// format of the new images: png = without loss; jpeg = smaller, with loss; an image with alpha becomes a PNG; webp = smaller still; programs need EXT_texture_webp
  ImageFormat imageFormat = ImageFormat::Png;
  /// quality of JPEG and WebP; with 100 WebP loses nothing
  int imageQuality = 90;
  /// texels around charts that take the colour of the nearest texel within
  int padding = 2;
  /// maximum number of threads, 0 for one per processor; results do not depend on it; small meshes use fewer, and builds without threads use one
  int threads = 0;
};

inline OptionInfos optionInfos(const BakeOptionValues&) {
  static constexpr OptionInfo kInfos[] = {
    {"bakeResolution", "--bake-resolution", "auto", "at least 16 and at most 8192, whole, or two of these, as in 2048x1024, or auto", "size of the new images in texels; of a number, the longer side of an image in the shape of the layout (auto = for each map the power of two that is nearest to the texels of the old images, or that of the layout if there are none)", false, false},
    {"imageFormat", "--image-format", "png", "png, jpeg, webp", "format of the new images: png = without loss; jpeg = smaller, with loss; an image with alpha becomes a PNG; webp = smaller still; programs need EXT_texture_webp", false, true},
    {"imageQuality", "--image-quality", "90", "at least 1 and at most 100, whole", "quality of JPEG and WebP; with 100 WebP loses nothing", false, false},
    {"padding", "--padding", "2", "at least 0 and at most 256, whole", "texels around charts that take the colour of the nearest texel within", false, false},
    {"threads", "--threads", "0", "at least 0 and at most 256, whole", "maximum number of threads, 0 for one per processor; results do not depend on it; small meshes use fewer, and builds without threads use one", false, false},
  };
  return {kInfos, 5};
}

/// Sets an option from a number: choices by their index, booleans as 0 or 1. False when out of range, with nothing set. Without `isWord`
/// the numbers that stand for words are refused.
inline bool setOption(BakeOptionValues& options, int index, double value,
                      [[maybe_unused]] bool isWord = true) {
  switch (index) {
    case 0: {
      const AtlasSize size = atlasSize(value, isWord);
      if (!((size.shorter() >= 16 && size.longer() <= 8192) || (isWord && value == 0))) return false;
      options.bakeResolution = size;
      return true;
    }
    case 1:
      if (!(value >= 0 && value < 3 && value == std::trunc(value))) return false;
      options.imageFormat = static_cast<ImageFormat>(static_cast<int>(value));
      return true;
    case 2:
      if (!((value >= 1 && value <= 100) && value == std::trunc(value))) return false;
      options.imageQuality = static_cast<int>(value);
      return true;
    case 3:
      if (!((value >= 0 && value <= 256) && value == std::trunc(value))) return false;
      options.padding = static_cast<int>(value);
      return true;
    case 4:
      if (!((value >= 0 && value <= 256) && value == std::trunc(value))) return false;
      options.threads = static_cast<int>(value);
      return true;
  }
  return false;
}

/// The number that stands for a word ("auto") or a choice of an option.
inline double wordValue(const BakeOptionValues&, int index, std::string_view text, bool& found) {
  if (index == 0 && text == "auto") return found = true, 0;
  if (index == 0) return atlasSizeValue(text, found);
  if (index == 1 && text == "png") return found = true, 0;
  if (index == 1 && text == "jpeg") return found = true, 1;
  if (index == 1 && text == "webp") return found = true, 2;
  return found = false, 0;
}

/// The size of a unit written behind a number ("3G") in the unit of the option; 0 when there is none of that name.
inline double unitSize(const BakeOptionValues&, [[maybe_unused]] int index,
                       [[maybe_unused]] char letter) {

  return 0;
}

/// Calls visit(name, value) for every option; words and choices are passed as text.
template <class Visit>
void forEachOption(const BakeOptionValues& options, Visit&& visit) {
  if (options.bakeResolution == 0)
    visit("bakeResolution", "auto");
  else
    visit("bakeResolution", options.bakeResolution);
  visit("imageFormat", nameOf(options.imageFormat));
  visit("imageQuality", options.imageQuality);
  visit("padding", options.padding);
  visit("threads", options.threads);
}

}  // namespace abflat
