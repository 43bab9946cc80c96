#pragma once

#include <array>

#include "layout/convex_combination.h"

namespace abflat {

/// Two boundary vertices far apart in 3D: the one farthest from the middle of the boundary, and the
/// one farthest from that. Independent of the numbering, up to ties.
std::array<ChartVertex, 2> findPins(const DiskChart& chart);

/// Lévy, Petitjean, Ray, Maillot: "Least squares conformal maps for automatic texture atlas
/// generation", 2002. The boundary is free, two pins on the u axis fix position, rotation and size.
/// Triangles may flip and the boundary may cross itself.
Embedding embedLscm(const DiskChart& chart);

}  // namespace abflat
