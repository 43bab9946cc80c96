#pragma once

#include <vector>

#include "seam/path_forest.h"
#include "seam/prediction.h"

namespace abflat {

/// Ends of the slits that relieve a chart most: reachable vertices with the greatest own stretch,
/// well apart from each other.
std::vector<OpenVertex> slitEnds(const CutPaths& paths, const Prediction& prediction,
                                 const LogScales& u, double maxStretch);

}  // namespace abflat
