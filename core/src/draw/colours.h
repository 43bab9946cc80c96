#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "draw/band.h"

namespace abflat {

/// Parses "#rrggbb".
Rgb parseColour(std::string_view hex);
std::string colourText(const Rgb& colour);

/// Pale colours that are easy to tell apart for charts with nearby numbers.
Rgb chartColour(std::uint32_t chart);

/// Blue below 1/2, white at 1, red above 2, linear in the logarithm of the ratio.
Rgb ratioColour(double ratio);

}  // namespace abflat
