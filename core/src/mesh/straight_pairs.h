#pragma once

#include <vector>

#include "mesh/corner_table.h"

namespace abflat {

/// Lets the surface go on across edges of three or more faces: joins those two faces that continue
/// straightest, two pairs of them where two surfaces cross. Faces that would bend more, and those
/// between which nothing but their numbers could decide, stay cut.
void joinStraightPairs(const std::vector<double>& positions, CornerTable& table);

}  // namespace abflat
