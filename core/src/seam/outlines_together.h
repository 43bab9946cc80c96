#pragma once

#include <utility>

#include "seam/outline.h"

namespace abflat {

/// Points of two outlines that should coincide.
using OutlinePairs = std::vector<std::pair<BoundaryIndex, BoundaryIndex>>;

/// Moves and rotates the second outline so that paired points coincide as well as possible. Returns
/// the area of the convex hull of both over the sum of their separate hulls.
double hullTogether(const Outline& a, const Outline& b, const OutlinePairs& pairs);

/// The common outline of the two when put together like that; `pairs` are in order and belong to
/// one run. Empty if they cannot be put together.
Outline outlineTogether(const Outline& a, const Outline& b, const OutlinePairs& pairs);

}  // namespace abflat
