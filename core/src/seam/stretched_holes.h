#pragma once

#include <vector>

#include "seam/prediction.h"

namespace abflat {

/// A vertex on the rim of each of the costliest filled holes of charts above the bound: those where
/// the stretch also exceeds the bound and is nearly that of the chart's worst hole.
std::vector<OpenVertex> stretchedHoles(const SeamMesh& mesh, const CutSurface& surface,
                                       const Prediction& prediction, const LogScales& u,
                                       double maxStretch);

}  // namespace abflat
