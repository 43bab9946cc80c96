#pragma once

#include "seam/path_forest.h"

namespace abflat {

/// Splits each wanted disk in two where that takes the least seam for the area that is cut off, and
/// adds the seams. Returns which charts were split; one that consists of a single face cannot be.
IdVector<CutChartId, std::uint8_t> halveCharts(const SeamMesh& mesh, const CutSurface& surface,
                                               const IdVector<CutChartId, std::uint8_t>& isWanted,
                                               Seams& seams);

}  // namespace abflat
