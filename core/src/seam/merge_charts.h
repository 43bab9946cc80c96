#pragma once

#include "seam/find_seams.h"
#include "seam/log_scale.h"

namespace abflat {

/// Joins neighbouring disks along a run of their common seam, the longest runs first, where the
/// union keeps the bounds and takes no more room than both: one linear system tells of as many
/// pairs as there are without a chart in common. Then those are joined along a part of a run whose
/// union keeps the bounds; both sides of what is left of the seam may be taken back. `kept` are
/// seams that stay, `scale` is that of the whole, whatever it has been solved for, `u` the
/// log-scale of the charts as they are, and then as they are joined; both per vertex. Returns how
/// many times that was done.
std::uint32_t mergeCharts(const SeamMesh& mesh, const Seams& kept, const SeamOptions& options,
                          LogScale& scale, std::vector<double>& u, Seams& seams);

}  // namespace abflat
