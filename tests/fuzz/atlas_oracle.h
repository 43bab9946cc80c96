#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace abflat::fuzz {

/// Triangles of an atlas by coordinates alone, 6 numbers each.
struct AtlasTriangles {
  std::vector<double> uv;
  std::vector<bool> mayBeFlat;  ///< has no area on the surface, so it needs none in the atlas
};

/// What is wrong with an atlas, empty where nothing is: a triangle that is turned over or has no
/// area, one outside of the tiles or in two of them, two that overlap. Exact, and independent of
/// the checks of the core.
std::string complaint(const AtlasTriangles& triangles, int tiles);

/// The same for a layout that lies anywhere in the plane.
std::string overlapComplaint(const AtlasTriangles& triangles);

/// Whether two counter-clockwise triangles of 6 numbers share more than boundary.
bool doOverlap(const double* a, const double* b);

}  // namespace abflat::fuzz
