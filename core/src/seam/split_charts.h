#pragma once

#include <vector>

#include "seam/path_forest.h"

namespace abflat {

struct ShapeOptions {
  double leastFill = 0;    ///< of the convex hull
  double mostOverlap = 0;  ///< of the chart's area
};

/// Splits the charts that are `asked` for until the layout told by `u`, cut along the new seams as
/// it lies, has no piece that covers too much of itself or too little of its convex hull. Leaves
/// 1 in `asked` where a chart was split, adds the seams and returns the number of splits.
std::uint32_t splitByShape(const SeamMesh& mesh, const CutSurface& surface,
                           const PathForest& forest, const std::vector<double>& u,
                           const ShapeOptions& options, std::vector<std::uint8_t>& asked,
                           Seams& seams);

}  // namespace abflat
