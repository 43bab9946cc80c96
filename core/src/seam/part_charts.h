#pragma once

#include <array>
#include <vector>

#include "seam/path_forest.h"

namespace abflat {

/// Half-edges on the outline of one chart.
using OutlinePair = std::array<SurfaceCorner, 2>;

/// Splits disks in two until the half-edges of each pair are in different pieces, with little seam
/// for the pairs that are parted at a time, and adds the seams. False if no pair can be parted.
bool partCharts(const SeamMesh& mesh, const std::vector<OutlinePair>& pairs, Seams& seams);

}  // namespace abflat
