// Generated from core/schema/abflat.json by scripts/generate.mjs, do not edit.
// clang-format off
#pragma once

#include <limits>

/// Defaults, bounds and help texts of FlattenOptions.
namespace abflat::defaults {

constexpr double kT = 1;
constexpr double kTAbove = 0;
constexpr const char* kTHelp = "boundary control coefficient: every boundary vertex of the layout has an interior angle of at most t*pi (1 = convex; 2 and above = free boundary, classic ABF)";
constexpr const char* kTRange = "above 0";
/// Finite and within the bounds.
constexpr bool isValidT(double value) {
  return value > kTAbove && value <= std::numeric_limits<double>::max();
}

}  // namespace abflat::defaults
