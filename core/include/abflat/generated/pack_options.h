// Generated from core/schema by scripts/generate.mjs, do not edit.
// clang-format off
#pragma once

#include <cmath>
#include <limits>
#include <string_view>

#include "abflat/generated/unwrap_options.h"

namespace abflat {

/// How large islands are beside each other.
enum class IslandSizes : int {
  Keep = 0,  ///< as large to each other as they are
  Even = 1,  ///< the same texel density for all; islands that lie on each other share one scale
};

inline const char* nameOf(IslandSizes code) {
  switch (code) {
    case IslandSizes::Keep:
      return "keep";
    case IslandSizes::Even:
      return "even";
  }
  return "";
}


/// The options of packing a layout that are plain values, with their defaults.
struct PackOptionValues {
  /// side of the texture in texels, or its width and height
  AtlasSize resolution = 1024;
  /// free texels between islands
  int padding = 2;
  /// free texels between islands and the edge of their tile (auto = half the padding, rounded up)
  int margin = -1;
  /// texels per mesh unit; use the same value for meshes that belong together (auto = as many as fit in one tile)
  double texelDensity = 0;
  /// use as many UDIM tiles as the texel density needs: from 1001 on, ten per row, u from 0 to 10
  bool udim = false;
  /// stretch level islands to whole texels, so that their sides lie on borders of texels
  bool snapToTexels = false;
  /// how islands are turned from how they lie to pack tighter: auto = by quarter turns, and charts whose outlines are not straight by any angle where that gains 4 % texels per unit or more; free = by any angle where that gains 3 % texels per unit or more, with up to 40 charts 5 %; quarter = by quarter turns only; none = not at all
  Rotate rotate = Rotate::Auto;
  /// how large islands are beside each other: keep = as large to each other as they are; even = the same texel density for all; islands that lie on each other share one scale
  IslandSizes islandSizes = IslandSizes::Keep;
  /// islands stay where they are, and the layout is only judged; of the other options only resolution and udim count then
  bool keepPlaces = false;
  /// maximum number of threads, 0 for one per processor; results do not depend on it; small meshes use fewer, and builds without threads use one
  int threads = 0;
};

inline OptionInfos optionInfos(const PackOptionValues&) {
  static constexpr OptionInfo kInfos[] = {
    {"resolution", "--resolution", "1024", "at least 16 and at most 32768, whole, or two of these, as in 2048x1024", "side of the texture in texels, or its width and height", false, false},
    {"padding", "--padding", "2", "at least 0 and at most 256, whole", "free texels between islands", false, false},
    {"margin", "--margin", "auto", "at least 0 and at most 256, whole, or auto", "free texels between islands and the edge of their tile (auto = half the padding, rounded up)", false, false},
    {"texelDensity", "--texel-density", "auto", "above 0, or auto", "texels per mesh unit; use the same value for meshes that belong together (auto = as many as fit in one tile)", false, false},
    {"udim", "--udim", "false", "", "use as many UDIM tiles as the texel density needs: from 1001 on, ten per row, u from 0 to 10", true, false},
    {"snapToTexels", "--snap-to-texels", "false", "", "stretch level islands to whole texels, so that their sides lie on borders of texels", true, false},
    {"rotate", "--rotate", "auto", "auto, free, quarter, none", "how islands are turned from how they lie to pack tighter: auto = by quarter turns, and charts whose outlines are not straight by any angle where that gains 4 % texels per unit or more; free = by any angle where that gains 3 % texels per unit or more, with up to 40 charts 5 %; quarter = by quarter turns only; none = not at all", false, true},
    {"islandSizes", "--island-sizes", "keep", "keep, even", "how large islands are beside each other: keep = as large to each other as they are; even = the same texel density for all; islands that lie on each other share one scale", false, true},
    {"keepPlaces", "--keep-places", "false", "", "islands stay where they are, and the layout is only judged; of the other options only resolution and udim count then", true, false},
    {"threads", "--threads", "0", "at least 0 and at most 256, whole", "maximum number of threads, 0 for one per processor; results do not depend on it; small meshes use fewer, and builds without threads use one", false, false},
  };
  return {kInfos, 10};
}

/// Sets an option from a number: choices by their index, booleans as 0 or 1. False when out of range, with nothing set. Without `isWord`
/// the numbers that stand for words are refused.
inline bool setOption(PackOptionValues& options, int index, double value,
                      [[maybe_unused]] bool isWord = true) {
  switch (index) {
    case 0: {
      const AtlasSize size = atlasSize(value, isWord);
      if (!((size.shorter() >= 16 && size.longer() <= 32768))) return false;
      options.resolution = size;
      return true;
    }
    case 1:
      if (!((value >= 0 && value <= 256) && value == std::trunc(value))) return false;
      options.padding = static_cast<int>(value);
      return true;
    case 2:
      if (!(((value >= 0 && value <= 256) || (isWord && value == -1)) && value == std::trunc(value))) return false;
      options.margin = static_cast<int>(value);
      return true;
    case 3:
      if (!((value > 0 && value <= std::numeric_limits<double>::max()) || (isWord && value == 0))) return false;
      options.texelDensity = static_cast<double>(value);
      return true;
    case 4:
      if (!(value == 0 || value == 1)) return false;
      options.udim = value != 0;
      return true;
    case 5:
      if (!(value == 0 || value == 1)) return false;
      options.snapToTexels = value != 0;
      return true;
    case 6:
      if (!(value >= 0 && value < 4 && value == std::trunc(value))) return false;
      options.rotate = static_cast<Rotate>(static_cast<int>(value));
      return true;
    case 7:
      if (!(value >= 0 && value < 2 && value == std::trunc(value))) return false;
      options.islandSizes = static_cast<IslandSizes>(static_cast<int>(value));
      return true;
    case 8:
      if (!(value == 0 || value == 1)) return false;
      options.keepPlaces = value != 0;
      return true;
    case 9:
      if (!((value >= 0 && value <= 256) && value == std::trunc(value))) return false;
      options.threads = static_cast<int>(value);
      return true;
  }
  return false;
}

/// The number that stands for a word ("auto") or a choice of an option.
inline double wordValue(const PackOptionValues&, int index, std::string_view text, bool& found) {
  if (index == 0) return atlasSizeValue(text, found);
  if (index == 2 && text == "auto") return found = true, -1;
  if (index == 3 && text == "auto") return found = true, 0;
  if (index == 6 && text == "auto") return found = true, 0;
  if (index == 6 && text == "free") return found = true, 1;
  if (index == 6 && text == "quarter") return found = true, 2;
  if (index == 6 && text == "none") return found = true, 3;
  if (index == 7 && text == "keep") return found = true, 0;
  if (index == 7 && text == "even") return found = true, 1;
  return found = false, 0;
}

/// The size of a unit written behind a number ("3G") in the unit of the option; 0 when there is none of that name.
inline double unitSize(const PackOptionValues&, [[maybe_unused]] int index,
                       [[maybe_unused]] char letter) {

  return 0;
}

/// Calls visit(name, value) for every option; words and choices are passed as text.
template <class Visit>
void forEachOption(const PackOptionValues& options, Visit&& visit) {
  visit("resolution", options.resolution);
  visit("padding", options.padding);
  if (options.margin == -1)
    visit("margin", "auto");
  else
    visit("margin", options.margin);
  if (options.texelDensity == 0)
    visit("texelDensity", "auto");
  else
    visit("texelDensity", options.texelDensity);
  visit("udim", options.udim);
  visit("snapToTexels", options.snapToTexels);
  visit("rotate", nameOf(options.rotate));
  visit("islandSizes", nameOf(options.islandSizes));
  visit("keepPlaces", options.keepPlaces);
  visit("threads", options.threads);
}

}  // namespace abflat
