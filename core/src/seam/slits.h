#pragma once

#include <vector>

#include "seam/path_forest.h"
#include "seam/prediction.h"

namespace abflat {

/// Ends of the slits that relieve a chart most: vertices of greatest own stretch, well apart, that
/// can be reached.
std::vector<std::uint32_t> slitEnds(const SeamMesh& mesh, const CutSurface& surface,
                                    const PathForest& forest, const Prediction& prediction,
                                    const std::vector<double>& u, double maxStretch);

}  // namespace abflat
