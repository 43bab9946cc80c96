#pragma once

#include <vector>

#include "seam/prediction.h"

namespace abflat {

/// A vertex on the rim of each filled hole that costs a chart above the bound most: where the chart
/// would be stretched by more than the bound, and nearly by as much as at its worst hole.
std::vector<OpenVertex> stretchedHoles(const SeamMesh& mesh, const CutSurface& surface,
                                       const Prediction& prediction, const LogScales& u,
                                       double maxStretch);

}  // namespace abflat
