#pragma once

#include "seam/seam_work.h"

namespace abflat {

/// Joins neighbouring disks along a run of their common seam, the longest runs first, if the union
/// keeps the bounds and takes no more room than both charts. One linear system checks as many pairs
/// as have no chart in common. Then joins charts along a part of a run if their union keeps the
/// bounds; both sides of the remaining seam may be taken back later. Returns the number of joins.
std::uint32_t mergeCharts(const SeamWork& work);

}  // namespace abflat
