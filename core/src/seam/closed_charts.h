#pragma once

#include <vector>

#include "seam/extract_charts.h"

namespace abflat {

/// The charts that these triangles are in, with their slits closed, but for those that are kept.
/// Takes time for these charts alone. `seams` are marked on both sides, `kept` may end early.
SeamPart extractClosed(const SeamMesh& mesh, const Seams& seams, const Seams& kept,
                       const std::vector<SurfaceTriangle>& ofCharts);

}  // namespace abflat
