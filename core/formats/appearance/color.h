#pragma once

#include <algorithm>

#include "base/portable_math.h"

namespace abflat {

/// Converts an sRGB channel from 0 to 1; values outside are clamped.
inline double linearOfSrgb(double value) {
  const double x = std::clamp(value, 0.0, 1.0);
  return x <= 0.04045 ? x / 12.92 : portable::exp(2.4 * portable::log((x + 0.055) / 1.055));
}

/// The inverse, also above 1.
inline double srgbOfLinear(double value) {
  const double x = std::max(value, 0.0);
  return x <= 0.0031308 ? 12.92 * x : 1.055 * portable::exp(portable::log(x) / 2.4) - 0.055;
}

}  // namespace abflat
