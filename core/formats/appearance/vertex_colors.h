#pragma once

#include <vector>

namespace abflat {

/// Red, green, blue and alpha per vertex, sRGB, from 0 to 1, or to 255 where any is above 1: made
/// linear, from 0 to 1. What is not a number is 1.
void makeLinear(std::vector<double>& colors);

}  // namespace abflat
