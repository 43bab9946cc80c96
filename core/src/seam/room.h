#pragma once

#include <utility>

#include "seam/outline.h"

namespace abflat {

/// Two outlines, the second one moved and turned so that pairs of their points come to lie on each
/// other as well as possible: area of the convex hull of both over the sum of those of each.
double roomTogether(const std::vector<Point2>& a, const std::vector<Point2>& b,
                    const std::vector<std::pair<std::size_t, std::size_t>>& pairs);

/// Their common outline, when they are put together so; `pairs` are in order, and those of a run.
/// Empty where they cannot be.
std::vector<Point2> outlineTogether(const std::vector<Point2>& a, const std::vector<Point2>& b,
                                    const std::vector<std::pair<std::size_t, std::size_t>>& pairs);

}  // namespace abflat
