#pragma once

#include <vector>

#include "mesh/corner_table.h"

namespace abflat {

/// Lets the surface go on across edges of three or more faces: joins those two faces that continue
/// straightest, two pairs of them where two surfaces cross. Faces that would bend more, and those
/// between which nothing but their numbers could decide, stay cut.
///
/// At an edge shorter than `fine`, the bend may be that of a step. If only two of its faces belong
/// to surfaces that do not end within a few triangles, these are joined, unless they bend by more
/// than 100 degrees.
void joinStraightPairs(const std::vector<double>& positions, double fine, CornerTable& table);

}  // namespace abflat
