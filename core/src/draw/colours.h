#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "draw/band.h"

namespace abflat {

/// Of "#rrggbb".
Rgb parseColour(std::string_view hex);
std::string colourText(const Rgb& colour);

/// Pale colours that differ well between charts whose numbers are near.
Rgb chartColour(std::uint32_t chart);

/// Blue below 1/2, white at 1, red above 2: the logarithm of the ratio in equal steps.
Rgb ratioColour(double ratio);

}  // namespace abflat
