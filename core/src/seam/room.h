#pragma once

#include <utility>

#include "seam/outline.h"

namespace abflat {

/// Points of two outlines that are to lie on each other.
using OutlinePairs = std::vector<std::pair<BoundaryIndex, BoundaryIndex>>;

/// Two outlines, the second one moved and turned so that pairs of their points come to lie on each
/// other as well as possible: area of the convex hull of both over the sum of those of each.
double roomTogether(const Outline& a, const Outline& b, const OutlinePairs& pairs);

/// Their common outline, when they are put together so; `pairs` are in order, and those of a run.
/// Empty where they cannot be.
Outline outlineTogether(const Outline& a, const Outline& b, const OutlinePairs& pairs);

}  // namespace abflat
