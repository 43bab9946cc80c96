// Generated from core/schema by scripts/generate.mjs, do not edit.
// clang-format off
#pragma once

#include <cmath>
#include <limits>
#include <string_view>

#include "abflat/atlas_size.h"
#include "abflat/generated/flatten_options.h"

namespace abflat {

/// Whether holes in charts, such as eye sockets and windows, are treated as filled and need no seams.
enum class FillHoles : int {
  Auto = 0,  ///< fill small or flat holes, unless a seam reaches them or the chart would be stretched too much
  Never = 1,  ///< connect every hole to the outer boundary by a seam
  Always = 2,  ///< fill them, however much that stretches
};

inline const char* nameOf(FillHoles code) {
  switch (code) {
    case FillHoles::Auto:
      return "auto";
    case FillHoles::Never:
      return "never";
    case FillHoles::Always:
      return "always";
  }
  return "";
}

/// What automatic seams are to have little of.
enum class SeamCosts : int {
  Sight = 0,  ///< how much they are in sight: creases hide seams, flat faces and the face of a figure do not
  Length = 1,  ///< their length alone, as papers and patterns have it
};

inline const char* nameOf(SeamCosts code) {
  switch (code) {
    case SeamCosts::Sight:
      return "sight";
    case SeamCosts::Length:
      return "length";
  }
  return "";
}

/// Whether automatic seams of a symmetric mesh are symmetric; parts without a mirror image do not matter.
enum class SymmetricSeams : int {
  Auto = 0,  ///< symmetric unless that makes seams more than a tenth costlier
  Never = 1,  ///< place each seam where it is best for its own side
  Always = 2,  ///< symmetric whatever that costs
};

inline const char* nameOf(SymmetricSeams code) {
  switch (code) {
    case SymmetricSeams::Auto:
      return "auto";
    case SymmetricSeams::Never:
      return "never";
    case SymmetricSeams::Always:
      return "always";
  }
  return "";
}

/// Whether outlines that are nearly straight become exactly so, and strips rectangles.
enum class Rectify : int {
  Auto = 0,  ///< where that hardly stretches, and stays within the bound of stretch
  Never = 1,  ///< leave outlines as they come out
  Always = 2,  ///< however much that stretches
};

inline const char* nameOf(Rectify code) {
  switch (code) {
    case Rectify::Auto:
      return "auto";
    case Rectify::Never:
      return "never";
    case Rectify::Always:
      return "always";
  }
  return "";
}

/// Whether charts may be cut so that all pack tighter.
enum class PackingCuts : int {
  Auto = 0,  ///< where that gains enough texels, see minUtilization
  Never = 1,  ///< every chart stays whole
};

inline const char* nameOf(PackingCuts code) {
  switch (code) {
    case PackingCuts::Auto:
      return "auto";
    case PackingCuts::Never:
      return "never";
  }
  return "";
}

/// Which axis of the mesh points up: charts that stand are laid out upright, and a face is looked for at the sides.
enum class Up : int {
  Auto = 0,  ///< z in STL files, y in all others
  Y = 1,  ///< the y axis
  Z = 2,  ///< the z axis
};

inline const char* nameOf(Up code) {
  switch (code) {
    case Up::Auto:
      return "auto";
    case Up::Y:
      return "y";
    case Up::Z:
      return "z";
  }
  return "";
}

/// How charts, which lie level and upright, are turned to pack tighter.
enum class Rotate : int {
  Auto = 0,  ///< by quarter turns, and charts whose outlines are not straight by any angle where that gains 4 % texels per unit or more
  Free = 1,  ///< by any angle where that gains 3 % texels per unit or more, with up to 40 charts 5 %
  Quarter = 2,  ///< by quarter turns only
  None = 3,  ///< not at all
};

inline const char* nameOf(Rotate code) {
  switch (code) {
    case Rotate::Auto:
      return "auto";
    case Rotate::Free:
      return "free";
    case Rotate::Quarter:
      return "quarter";
    case Rotate::None:
      return "none";
  }
  return "";
}

/// Which parts and charts of equal shape lie on each other and share their texels.
enum class Stack : int {
  None = 0,  ///< each has texels of its own
  Identical = 1,  ///< those that are moved and turned
  Mirrored = 2,  ///< mirror images as well, whose triangles run clockwise in the atlas
};

inline const char* nameOf(Stack code) {
  switch (code) {
    case Stack::None:
      return "none";
    case Stack::Identical:
      return "identical";
    case Stack::Mirrored:
      return "mirrored";
  }
  return "";
}

/// "auto" as a value of the option maxSheared.
constexpr double kAutoMaxSheared = -1;
/// "auto" as a value of the option margin.
constexpr int kAutoMargin = -1;
/// "auto" as a value of the option texelDensity.
constexpr double kAutoTexelDensity = 0;
/// "auto" as a value of the option minUtilization.
constexpr double kAutoMinUtilization = -1;

/// The options of unwrapping that are plain values, with their defaults.
struct UnwrapOptionValues {
  /// largest stretch of a chart: its mean symmetric Dirichlet energy / 4, where 1 keeps all lengths; smaller values give more seams and charts
  double maxStretch = 1.02;
  /// largest share of a chart's surface that may be sheared, that is, have a quasi-conformal distortion above 1.25, as if a square became a rectangle of 5 by 4; charts with more are cut further (1 = no limit; auto = 0.1, or 5 times what maxStretch is above 1, if that is more)
  double maxSheared = -1;
  /// how much more the front of a figure, such as a face, may be stretched so that no seam crosses it: so many times maxStretch - 1, and as many times maxSheared; half as much again on a mask that then needs no seam at all (1 = no more than elsewhere)
  double frontLeeway = 14;
  /// trade-off between angles and lengths: 0 keeps the angles as flattening found them, 1 keeps areas and lengths as well as possible (least symmetric Dirichlet energy)
  double balance = 0.2;
  /// turn faces so that neighbours run alike, in the layout and in the output, before seams are placed; normals stay as they are
  bool orient = false;
  /// whether holes in charts, such as eye sockets and windows, are treated as filled and need no seams: auto = fill small or flat holes, unless a seam reaches them or the chart would be stretched too much; never = connect every hole to the outer boundary by a seam; always = fill them, however much that stretches
  FillHoles fillHoles = FillHoles::Auto;
  /// what automatic seams are to have little of: sight = how much they are in sight: creases hide seams, flat faces and the face of a figure do not; length = their length alone, as papers and patterns have it
  SeamCosts seamCosts = SeamCosts::Sight;
  /// whether automatic seams of a symmetric mesh are symmetric; parts without a mirror image do not matter: auto = symmetric unless that makes seams more than a tenth costlier; never = place each seam where it is best for its own side; always = symmetric whatever that costs
  SymmetricSeams symmetricSeams = SymmetricSeams::Auto;
  /// boundary control coefficient: every interior angle of the boundary is at most t*pi (1 = convex; 2 or more = free boundary, classic ABF; auto = free, or the bounds of least distortion if a free boundary would cross itself)
  double t = 0;
  /// make seams and boundaries straight in the atlas, from junction to junction and corner to corner; curves that turn by more than 90 degrees in all, such as the rim of a round lid, stay curved
  bool straightSeams = false;
  /// whether outlines that are nearly straight become exactly so, and strips rectangles: auto = where that hardly stretches, and stays within the bound of stretch; never = leave outlines as they come out; always = however much that stretches
  Rectify rectify = Rectify::Auto;
  /// side of the texture in texels, or its width and height
  AtlasSize resolution = 1024;
  /// free texels between charts, and between far parts of one chart
  int padding = 2;
  /// free texels between charts and the edge of their tile (auto = half the padding, rounded up)
  int margin = -1;
  /// texels per mesh unit; use the same value for meshes that belong together (auto = as many as fit in one tile)
  double texelDensity = 0;
  /// use as many UDIM tiles as the texel density needs: from 1001 on, ten per row, u from 0 to 10
  bool udim = false;
  /// stretch level charts to whole texels, so that their sides lie on borders of texels
  bool snapToTexels = false;
  /// whether charts may be cut so that all pack tighter: auto = where that gains enough texels, see minUtilization; never = every chart stays whole
  PackingCuts packingCuts = PackingCuts::Auto;
  /// share of the tile that charts should cover: charts are cut until they do, or until cutting stops helping, and then a note says why (0 = leave charts whole, like packingCuts = never; auto = cut long charts across, and others along creases, where that gains at least 5 % texels per unit for each of the first four cuts, 1.5 % per further cut, and 4 % per seam in plain sight as long as the square root of the surface area)
  double minUtilization = -1;
  /// which axis of the mesh points up: charts that stand are laid out upright, and a face is looked for at the sides: auto = z in STL files, y in all others; y = the y axis; z = the z axis
  Up up = Up::Auto;
  /// how charts, which lie level and upright, are turned to pack tighter: auto = by quarter turns, and charts whose outlines are not straight by any angle where that gains 4 % texels per unit or more; free = by any angle where that gains 3 % texels per unit or more, with up to 40 charts 5 %; quarter = by quarter turns only; none = not at all
  Rotate rotate = Rotate::Auto;
  /// which parts and charts of equal shape lie on each other and share their texels: none = each has texels of its own; identical = those that are moved and turned; mirrored = mirror images as well, whose triangles run clockwise in the atlas
  Stack stack = Stack::None;
  /// memory for the factor of the solver's matrix, in MB; if it does not fit, the solver uses single precision, or conjugate gradients with multigrid (auto = 3072 in WebAssembly, no limit natively)
  double memory = 0;
  /// maximum number of threads, 0 for one per processor; results do not depend on it; small meshes use fewer, and builds without threads use one
  int threads = 0;
};

inline OptionInfos optionInfos(const UnwrapOptionValues&) {
  static constexpr OptionInfo kInfos[] = {
    {"maxStretch", "--max-stretch", "1.02", "above 1", "largest stretch of a chart: its mean symmetric Dirichlet energy / 4, where 1 keeps all lengths; smaller values give more seams and charts", false, false},
    {"maxSheared", "--max-sheared", "auto", "above 0 and at most 1, or auto", "largest share of a chart's surface that may be sheared, that is, have a quasi-conformal distortion above 1.25, as if a square became a rectangle of 5 by 4; charts with more are cut further (1 = no limit; auto = 0.1, or 5 times what maxStretch is above 1, if that is more)", false, false},
    {"frontLeeway", "--front-leeway", "14", "at least 1 and at most 100", "how much more the front of a figure, such as a face, may be stretched so that no seam crosses it: so many times maxStretch - 1, and as many times maxSheared; half as much again on a mask that then needs no seam at all (1 = no more than elsewhere)", false, false},
    {"balance", "--balance", "0.2", "at least 0 and at most 1", "trade-off between angles and lengths: 0 keeps the angles as flattening found them, 1 keeps areas and lengths as well as possible (least symmetric Dirichlet energy)", false, false},
    {"orient", "--orient", "false", "", "turn faces so that neighbours run alike, in the layout and in the output, before seams are placed; normals stay as they are", true, false},
    {"fillHoles", "--fill-holes", "auto", "auto, never, always", "whether holes in charts, such as eye sockets and windows, are treated as filled and need no seams: auto = fill small or flat holes, unless a seam reaches them or the chart would be stretched too much; never = connect every hole to the outer boundary by a seam; always = fill them, however much that stretches", false, true},
    {"seamCosts", "--seam-costs", "sight", "sight, length", "what automatic seams are to have little of: sight = how much they are in sight: creases hide seams, flat faces and the face of a figure do not; length = their length alone, as papers and patterns have it", false, true},
    {"symmetricSeams", "--symmetric-seams", "auto", "auto, never, always", "whether automatic seams of a symmetric mesh are symmetric; parts without a mirror image do not matter: auto = symmetric unless that makes seams more than a tenth costlier; never = place each seam where it is best for its own side; always = symmetric whatever that costs", false, true},
    {"t", "--t", "auto", "above 0, or auto", "boundary control coefficient: every interior angle of the boundary is at most t*pi (1 = convex; 2 or more = free boundary, classic ABF; auto = free, or the bounds of least distortion if a free boundary would cross itself)", false, false},
    {"straightSeams", "--straight-seams", "false", "", "make seams and boundaries straight in the atlas, from junction to junction and corner to corner; curves that turn by more than 90 degrees in all, such as the rim of a round lid, stay curved", true, false},
    {"rectify", "--rectify", "auto", "auto, never, always", "whether outlines that are nearly straight become exactly so, and strips rectangles: auto = where that hardly stretches, and stays within the bound of stretch; never = leave outlines as they come out; always = however much that stretches", false, true},
    {"resolution", "--resolution", "1024", "at least 16 and at most 32768, whole, or two of these, as in 2048x1024", "side of the texture in texels, or its width and height", false, false},
    {"padding", "--padding", "2", "at least 0 and at most 256, whole", "free texels between charts, and between far parts of one chart", false, false},
    {"margin", "--margin", "auto", "at least 0 and at most 256, whole, or auto", "free texels between charts and the edge of their tile (auto = half the padding, rounded up)", false, false},
    {"texelDensity", "--texel-density", "auto", "above 0, or auto", "texels per mesh unit; use the same value for meshes that belong together (auto = as many as fit in one tile)", false, false},
    {"udim", "--udim", "false", "", "use as many UDIM tiles as the texel density needs: from 1001 on, ten per row, u from 0 to 10", true, false},
    {"snapToTexels", "--snap-to-texels", "false", "", "stretch level charts to whole texels, so that their sides lie on borders of texels", true, false},
    {"packingCuts", "--packing-cuts", "auto", "auto, never", "whether charts may be cut so that all pack tighter: auto = where that gains enough texels, see minUtilization; never = every chart stays whole", false, true},
    {"minUtilization", "--min-utilization", "auto", "at least 0 and at most 1, or auto", "share of the tile that charts should cover: charts are cut until they do, or until cutting stops helping, and then a note says why (0 = leave charts whole, like packingCuts = never; auto = cut long charts across, and others along creases, where that gains at least 5 % texels per unit for each of the first four cuts, 1.5 % per further cut, and 4 % per seam in plain sight as long as the square root of the surface area)", false, false},
    {"up", "--up", "auto", "auto, y, z", "which axis of the mesh points up: charts that stand are laid out upright, and a face is looked for at the sides: auto = z in STL files, y in all others; y = the y axis; z = the z axis", false, true},
    {"rotate", "--rotate", "auto", "auto, free, quarter, none", "how charts, which lie level and upright, are turned to pack tighter: auto = by quarter turns, and charts whose outlines are not straight by any angle where that gains 4 % texels per unit or more; free = by any angle where that gains 3 % texels per unit or more, with up to 40 charts 5 %; quarter = by quarter turns only; none = not at all", false, true},
    {"stack", "--stack", "none", "none, identical, mirrored", "which parts and charts of equal shape lie on each other and share their texels: none = each has texels of its own; identical = those that are moved and turned; mirrored = mirror images as well, whose triangles run clockwise in the atlas", false, true},
    {"memory", "--memory", "auto", "above 0, or auto", "memory for the factor of the solver's matrix, in MB; if it does not fit, the solver uses single precision, or conjugate gradients with multigrid (auto = 3072 in WebAssembly, no limit natively)", false, false},
    {"threads", "--threads", "0", "at least 0 and at most 256, whole", "maximum number of threads, 0 for one per processor; results do not depend on it; small meshes use fewer, and builds without threads use one", false, false},
  };
  return {kInfos, 24};
}

/// Sets an option from a number: choices by their index, booleans as 0 or 1. False when out of range, with nothing set. Without `isWord`
/// the numbers that stand for words are refused.
inline bool setOption(UnwrapOptionValues& options, int index, double value,
                      [[maybe_unused]] bool isWord = true) {
  switch (index) {
    case 0:
      if (!(value > 1 && value <= std::numeric_limits<double>::max())) return false;
      options.maxStretch = static_cast<double>(value);
      return true;
    case 1:
      if (!((value > 0 && value <= 1) || (isWord && value == -1))) return false;
      options.maxSheared = static_cast<double>(value);
      return true;
    case 2:
      if (!(value >= 1 && value <= 100)) return false;
      options.frontLeeway = static_cast<double>(value);
      return true;
    case 3:
      if (!(value >= 0 && value <= 1)) return false;
      options.balance = static_cast<double>(value);
      return true;
    case 4:
      if (!(value == 0 || value == 1)) return false;
      options.orient = value != 0;
      return true;
    case 5:
      if (!(value >= 0 && value < 3 && value == std::trunc(value))) return false;
      options.fillHoles = static_cast<FillHoles>(static_cast<int>(value));
      return true;
    case 6:
      if (!(value >= 0 && value < 2 && value == std::trunc(value))) return false;
      options.seamCosts = static_cast<SeamCosts>(static_cast<int>(value));
      return true;
    case 7:
      if (!(value >= 0 && value < 3 && value == std::trunc(value))) return false;
      options.symmetricSeams = static_cast<SymmetricSeams>(static_cast<int>(value));
      return true;
    case 8:
      if (!((value > 0 && value <= std::numeric_limits<double>::max()) || (isWord && value == 0))) return false;
      options.t = static_cast<double>(value);
      return true;
    case 9:
      if (!(value == 0 || value == 1)) return false;
      options.straightSeams = value != 0;
      return true;
    case 10:
      if (!(value >= 0 && value < 3 && value == std::trunc(value))) return false;
      options.rectify = static_cast<Rectify>(static_cast<int>(value));
      return true;
    case 11: {
      const AtlasSize size = atlasSize(value, isWord);
      if (!((size.shorter() >= 16 && size.longer() <= 32768))) return false;
      options.resolution = size;
      return true;
    }
    case 12:
      if (!((value >= 0 && value <= 256) && value == std::trunc(value))) return false;
      options.padding = static_cast<int>(value);
      return true;
    case 13:
      if (!(((value >= 0 && value <= 256) || (isWord && value == -1)) && value == std::trunc(value))) return false;
      options.margin = static_cast<int>(value);
      return true;
    case 14:
      if (!((value > 0 && value <= std::numeric_limits<double>::max()) || (isWord && value == 0))) return false;
      options.texelDensity = static_cast<double>(value);
      return true;
    case 15:
      if (!(value == 0 || value == 1)) return false;
      options.udim = value != 0;
      return true;
    case 16:
      if (!(value == 0 || value == 1)) return false;
      options.snapToTexels = value != 0;
      return true;
    case 17:
      if (!(value >= 0 && value < 2 && value == std::trunc(value))) return false;
      options.packingCuts = static_cast<PackingCuts>(static_cast<int>(value));
      return true;
    case 18:
      if (!((value >= 0 && value <= 1) || (isWord && value == -1))) return false;
      options.minUtilization = static_cast<double>(value);
      return true;
    case 19:
      if (!(value >= 0 && value < 3 && value == std::trunc(value))) return false;
      options.up = static_cast<Up>(static_cast<int>(value));
      return true;
    case 20:
      if (!(value >= 0 && value < 4 && value == std::trunc(value))) return false;
      options.rotate = static_cast<Rotate>(static_cast<int>(value));
      return true;
    case 21:
      if (!(value >= 0 && value < 3 && value == std::trunc(value))) return false;
      options.stack = static_cast<Stack>(static_cast<int>(value));
      return true;
    case 22:
      if (!((value > 0 && value <= std::numeric_limits<double>::max()) || (isWord && value == 0))) return false;
      options.memory = static_cast<double>(value);
      return true;
    case 23:
      if (!((value >= 0 && value <= 256) && value == std::trunc(value))) return false;
      options.threads = static_cast<int>(value);
      return true;
  }
  return false;
}

/// The number that stands for a word ("auto") or a choice of an option.
inline double wordValue(const UnwrapOptionValues&, int index, std::string_view text, bool& found) {
  if (index == 1 && text == "auto") return found = true, -1;
  if (index == 5 && text == "auto") return found = true, 0;
  if (index == 5 && text == "never") return found = true, 1;
  if (index == 5 && text == "always") return found = true, 2;
  if (index == 6 && text == "sight") return found = true, 0;
  if (index == 6 && text == "length") return found = true, 1;
  if (index == 7 && text == "auto") return found = true, 0;
  if (index == 7 && text == "never") return found = true, 1;
  if (index == 7 && text == "always") return found = true, 2;
  if (index == 8 && text == "auto") return found = true, 0;
  if (index == 10 && text == "auto") return found = true, 0;
  if (index == 10 && text == "never") return found = true, 1;
  if (index == 10 && text == "always") return found = true, 2;
  if (index == 11) return atlasSizeValue(text, found);
  if (index == 13 && text == "auto") return found = true, -1;
  if (index == 14 && text == "auto") return found = true, 0;
  if (index == 17 && text == "auto") return found = true, 0;
  if (index == 17 && text == "never") return found = true, 1;
  if (index == 18 && text == "auto") return found = true, -1;
  if (index == 19 && text == "auto") return found = true, 0;
  if (index == 19 && text == "y") return found = true, 1;
  if (index == 19 && text == "z") return found = true, 2;
  if (index == 20 && text == "auto") return found = true, 0;
  if (index == 20 && text == "free") return found = true, 1;
  if (index == 20 && text == "quarter") return found = true, 2;
  if (index == 20 && text == "none") return found = true, 3;
  if (index == 21 && text == "none") return found = true, 0;
  if (index == 21 && text == "identical") return found = true, 1;
  if (index == 21 && text == "mirrored") return found = true, 2;
  if (index == 22 && text == "auto") return found = true, 0;
  return found = false, 0;
}

/// The size of a unit written behind a number ("3G") in the unit of the option; 0 when there is none of that name.
inline double unitSize(const UnwrapOptionValues&, [[maybe_unused]] int index,
                       [[maybe_unused]] char letter) {
  if (index == 22 && letter == 'M') return 1;
  if (index == 22 && letter == 'G') return 1024;
  if (index == 22 && letter == 'T') return 1048576;
  return 0;
}

/// Calls visit(name, value) for every option; words and choices are passed as text.
template <class Visit>
void forEachOption(const UnwrapOptionValues& options, Visit&& visit) {
  visit("maxStretch", options.maxStretch);
  if (options.maxSheared == -1)
    visit("maxSheared", "auto");
  else
    visit("maxSheared", options.maxSheared);
  visit("frontLeeway", options.frontLeeway);
  visit("balance", options.balance);
  visit("orient", options.orient);
  visit("fillHoles", nameOf(options.fillHoles));
  visit("seamCosts", nameOf(options.seamCosts));
  visit("symmetricSeams", nameOf(options.symmetricSeams));
  if (options.t == 0)
    visit("t", "auto");
  else
    visit("t", options.t);
  visit("straightSeams", options.straightSeams);
  visit("rectify", nameOf(options.rectify));
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
  visit("packingCuts", nameOf(options.packingCuts));
  if (options.minUtilization == -1)
    visit("minUtilization", "auto");
  else
    visit("minUtilization", options.minUtilization);
  visit("up", nameOf(options.up));
  visit("rotate", nameOf(options.rotate));
  visit("stack", nameOf(options.stack));
  if (options.memory == 0)
    visit("memory", "auto");
  else
    visit("memory", options.memory);
  visit("threads", options.threads);
}

}  // namespace abflat
