#pragma once

#include <cmath>

#include "abflat/unwrap.h"

namespace abflat {

/// Texels per unit before packing tells: those asked for, or what charts get that cover a usual
/// share of the atlas. `area` of the surface in a unit that is `unit` of the mesh's long; so is the
/// result's.
inline double expectedDensity(const UnwrapOptions& options, double area, double unit) {
  constexpr double kUsualUtilization = 0.6;
  if (options.texelDensity != kAutoTexelDensity) return options.texelDensity * unit;
  return options.resolution.meanSide() * std::sqrt(kUsualUtilization / area);
}

}  // namespace abflat
