// Generated from core/schema by scripts/generate.mjs, do not edit.
// clang-format off
#pragma once

#include <cmath>
#include <limits>
#include <string_view>

#include "abflat/generated/bake_options.h"

namespace abflat {

/// "none" as a value of the option minTexelDensity.
constexpr double kNoneMinTexelDensity = 0;
/// "none" as a value of the option maxTexelDensity.
constexpr double kNoneMaxTexelDensity = 0;
/// "none" as a value of the option maxDensityRatio.
constexpr double kNoneMaxDensityRatio = 0;
/// "none" as a value of the option maxIslands.
constexpr int kNoneMaxIslands = 0;

/// What a layout must keep to, as plain values, with their defaults.
struct VerifyOptionValues {
  /// side of the texture in texels, or its width and height: for distances, widths and texel densities
  AtlasSize resolution = 1024;
  /// islands may lie in any UDIM tile: from 1001 on, ten per row, u from 0 to 10
  bool udim = false;
  /// least distance between two islands in texels
  double padding = 0;
  /// least distance between an island and the edge of its tile in texels
  double margin = 0;
  /// mip levels below the texture in which padding and margin must hold, too: distances are half as many texels in each
  int mipLevels = 0;
  /// least width of an island in texels, across the shorter side of its smallest box
  double minIslandWidth = 0;
  /// least texels per mesh unit of a face; a glTF is in metres
  double minTexelDensity = 0;
  /// most texels per mesh unit of a face
  double maxTexelDensity = 0;
  /// how many times as dense as another an island may be
  double maxDensityRatio = 0;
  /// largest stretch of an island: its mean symmetric Dirichlet energy / 4, where 1 keeps all lengths
  double maxStretch = 0;
  /// least share of the tiles that islands cover
  double minUtilization = 0;
  /// most islands
  int maxIslands = 0;
  /// islands may lie on each other if they cover the same place
  bool allowStacked = false;
  /// whole islands may run clockwise
  bool allowMirrored = false;
  /// islands may overlap others and themselves
  bool allowOverlaps = false;
  /// islands may leave their tile, as with textures that repeat
  bool allowOutsideTiles = false;
  /// faces with area may have none in uv
  bool allowEmpty = false;
  /// faces may be without texcoords
  bool allowUnmapped = false;
};

inline OptionInfos optionInfos(const VerifyOptionValues&) {
  static constexpr OptionInfo kInfos[] = {
    {"resolution", "--resolution", "1024", "at least 16 and at most 32768, whole, or two of these, as in 2048x1024", "side of the texture in texels, or its width and height: for distances, widths and texel densities", false, false},
    {"udim", "--udim", "false", "", "islands may lie in any UDIM tile: from 1001 on, ten per row, u from 0 to 10", true, false},
    {"padding", "--padding", "0", "at least 0 and at most 1024", "least distance between two islands in texels", false, false},
    {"margin", "--margin", "0", "at least 0 and at most 1024", "least distance between an island and the edge of its tile in texels", false, false},
    {"mipLevels", "--mip-levels", "0", "at least 0 and at most 15, whole", "mip levels below the texture in which padding and margin must hold, too: distances are half as many texels in each", false, false},
    {"minIslandWidth", "--min-island-width", "0", "at least 0 and at most 32768", "least width of an island in texels, across the shorter side of its smallest box", false, false},
    {"minTexelDensity", "--min-texel-density", "none", "above 0, or none", "least texels per mesh unit of a face; a glTF is in metres", false, false},
    {"maxTexelDensity", "--max-texel-density", "none", "above 0, or none", "most texels per mesh unit of a face", false, false},
    {"maxDensityRatio", "--max-density-ratio", "none", "at least 1, or none", "how many times as dense as another an island may be", false, false},
    {"maxStretch", "--max-stretch", "none", "above 1, or none", "largest stretch of an island: its mean symmetric Dirichlet energy / 4, where 1 keeps all lengths", false, false},
    {"minUtilization", "--min-utilization", "0", "at least 0 and at most 1", "least share of the tiles that islands cover", false, false},
    {"maxIslands", "--max-islands", "none", "at least 1 and at most 1000000000, whole, or none", "most islands", false, false},
    {"allowStacked", "--allow-stacked", "false", "", "islands may lie on each other if they cover the same place", true, false},
    {"allowMirrored", "--allow-mirrored", "false", "", "whole islands may run clockwise", true, false},
    {"allowOverlaps", "--allow-overlaps", "false", "", "islands may overlap others and themselves", true, false},
    {"allowOutsideTiles", "--allow-outside-tiles", "false", "", "islands may leave their tile, as with textures that repeat", true, false},
    {"allowEmpty", "--allow-empty", "false", "", "faces with area may have none in uv", true, false},
    {"allowUnmapped", "--allow-unmapped", "false", "", "faces may be without texcoords", true, false},
  };
  return {kInfos, 18};
}

/// Sets an option from a number: choices by their index, booleans as 0 or 1. False when out of range, with nothing set. Without `isWord`
/// the numbers that stand for words are refused.
inline bool setOption(VerifyOptionValues& options, int index, double value,
                      [[maybe_unused]] bool isWord = true) {
  switch (index) {
    case 0: {
      const AtlasSize size = atlasSize(value, isWord);
      if (!((size.shorter() >= 16 && size.longer() <= 32768))) return false;
      options.resolution = size;
      return true;
    }
    case 1:
      if (!(value == 0 || value == 1)) return false;
      options.udim = value != 0;
      return true;
    case 2:
      if (!(value >= 0 && value <= 1024)) return false;
      options.padding = static_cast<double>(value);
      return true;
    case 3:
      if (!(value >= 0 && value <= 1024)) return false;
      options.margin = static_cast<double>(value);
      return true;
    case 4:
      if (!((value >= 0 && value <= 15) && value == std::trunc(value))) return false;
      options.mipLevels = static_cast<int>(value);
      return true;
    case 5:
      if (!(value >= 0 && value <= 32768)) return false;
      options.minIslandWidth = static_cast<double>(value);
      return true;
    case 6:
      if (!((value > 0 && value <= std::numeric_limits<double>::max()) || (isWord && value == 0))) return false;
      options.minTexelDensity = static_cast<double>(value);
      return true;
    case 7:
      if (!((value > 0 && value <= std::numeric_limits<double>::max()) || (isWord && value == 0))) return false;
      options.maxTexelDensity = static_cast<double>(value);
      return true;
    case 8:
      if (!((value >= 1 && value <= std::numeric_limits<double>::max()) || (isWord && value == 0))) return false;
      options.maxDensityRatio = static_cast<double>(value);
      return true;
    case 9:
      if (!((value > 1 && value <= std::numeric_limits<double>::max()) || (isWord && value == 0))) return false;
      options.maxStretch = static_cast<double>(value);
      return true;
    case 10:
      if (!(value >= 0 && value <= 1)) return false;
      options.minUtilization = static_cast<double>(value);
      return true;
    case 11:
      if (!(((value >= 1 && value <= 1000000000) || (isWord && value == 0)) && value == std::trunc(value))) return false;
      options.maxIslands = static_cast<int>(value);
      return true;
    case 12:
      if (!(value == 0 || value == 1)) return false;
      options.allowStacked = value != 0;
      return true;
    case 13:
      if (!(value == 0 || value == 1)) return false;
      options.allowMirrored = value != 0;
      return true;
    case 14:
      if (!(value == 0 || value == 1)) return false;
      options.allowOverlaps = value != 0;
      return true;
    case 15:
      if (!(value == 0 || value == 1)) return false;
      options.allowOutsideTiles = value != 0;
      return true;
    case 16:
      if (!(value == 0 || value == 1)) return false;
      options.allowEmpty = value != 0;
      return true;
    case 17:
      if (!(value == 0 || value == 1)) return false;
      options.allowUnmapped = value != 0;
      return true;
  }
  return false;
}

/// The number that stands for a word ("auto") or a choice of an option.
inline double wordValue(const VerifyOptionValues&, int index, std::string_view text, bool& found) {
  if (index == 0) return atlasSizeValue(text, found);
  if (index == 6 && text == "none") return found = true, 0;
  if (index == 7 && text == "none") return found = true, 0;
  if (index == 8 && text == "none") return found = true, 0;
  if (index == 9 && text == "none") return found = true, 0;
  if (index == 11 && text == "none") return found = true, 0;
  return found = false, 0;
}

/// The size of a unit written behind a number ("3G") in the unit of the option; 0 when there is none of that name.
inline double unitSize(const VerifyOptionValues&, [[maybe_unused]] int index,
                       [[maybe_unused]] char letter) {

  return 0;
}

/// Calls visit(name, value) for every option; words and choices are passed as text.
template <class Visit>
void forEachOption(const VerifyOptionValues& options, Visit&& visit) {
  visit("resolution", options.resolution);
  visit("udim", options.udim);
  visit("padding", options.padding);
  visit("margin", options.margin);
  visit("mipLevels", options.mipLevels);
  visit("minIslandWidth", options.minIslandWidth);
  if (options.minTexelDensity == 0)
    visit("minTexelDensity", "none");
  else
    visit("minTexelDensity", options.minTexelDensity);
  if (options.maxTexelDensity == 0)
    visit("maxTexelDensity", "none");
  else
    visit("maxTexelDensity", options.maxTexelDensity);
  if (options.maxDensityRatio == 0)
    visit("maxDensityRatio", "none");
  else
    visit("maxDensityRatio", options.maxDensityRatio);
  if (options.maxStretch == 0)
    visit("maxStretch", "none");
  else
    visit("maxStretch", options.maxStretch);
  visit("minUtilization", options.minUtilization);
  if (options.maxIslands == 0)
    visit("maxIslands", "none");
  else
    visit("maxIslands", options.maxIslands);
  visit("allowStacked", options.allowStacked);
  visit("allowMirrored", options.allowMirrored);
  visit("allowOverlaps", options.allowOverlaps);
  visit("allowOutsideTiles", options.allowOutsideTiles);
  visit("allowEmpty", options.allowEmpty);
  visit("allowUnmapped", options.allowUnmapped);
}

}  // namespace abflat
