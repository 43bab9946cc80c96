#pragma once

#include <vector>

namespace abflat {

/// Whether no two edges of a closed polygon cross or touch, but for neighbours at their common
/// corner, decided exactly in n log n steps whatever its form (a sweep after Shamos and Hoey).
/// False where points are not finite.
bool isSimplePolygon(const std::vector<double>& points);

}  // namespace abflat
