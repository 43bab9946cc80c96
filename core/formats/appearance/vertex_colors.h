#pragma once

#include <vector>

namespace abflat {

/// Red, green, blue and alpha per vertex, in sRGB, from 0 to 1, or to 255 if any value is above 1:
/// converted to linear values from 0 to 1. Anything that is not a number becomes 1.
void makeLinear(std::vector<double>& colors);

}  // namespace abflat
