#pragma once

#include "seam/seam_work.h"

namespace abflat {

/// Joins neighbouring disks along a run of their common seam, the longest runs first, where the
/// union keeps the bounds and takes no more room than both: one linear system tells of as many
/// pairs as there are without a chart in common. Then those are joined along a part of a run whose
/// union keeps the bounds; both sides of what is left of the seam may be taken back. Returns how
/// many times that was done.
std::uint32_t mergeCharts(const SeamWork& work);

}  // namespace abflat
