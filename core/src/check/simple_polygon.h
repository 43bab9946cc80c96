#pragma once

#include <vector>

namespace abflat {

/// Whether no two edges of a closed polygon cross or touch, except neighbours at their common
/// corner. Decided exactly in O(n log n) whatever the shape (a sweep after Shamos and Hoey). False
/// if points are not finite.
bool isSimplePolygon(const std::vector<double>& points);

}  // namespace abflat
