#pragma once

#include <string>

#include "base/point2.h"
#include "unwrap/fixed.h"

namespace abflat {

inline std::string nameOf(InputFace face) { return "face " + std::to_string(face); }

/// The lower left corner of the tile that contains the middle of an island's box.
Point2 tileAround(const Point2& low, const Point2& high, bool hasTiles);

/// Frees islands of the input that cannot stay: a face has no texcoords, is mirrored, degenerate or
/// not inside the island's tile, or the island overlaps itself or one that stays. Of two that
/// overlap, a known chart or else the larger one stays. Returns a note that names those freed;
/// empty if all stay.
std::string freeUnfitIslands(const SurfaceMap& map, bool hasTiles, FixedTriangles& fixed);

}  // namespace abflat
