#pragma once

#include <vector>

#include "seam/path_forest.h"

namespace abflat {

struct ShapeOptions {
  double leastFill = 0;    ///< of the convex hull
  double mostOverlap = 0;  ///< of the chart's area
};

/// What a chart is split for.
enum class SplitFor : std::uint8_t { Nothing, Overlap, OverlapOrFill };

/// Splits charts for what is `asked` until the layout told by `u`, cut along the new seams as
/// it lies, has no piece that covers too much of itself or too little of its convex hull. Leaves
/// Nothing in `asked` where a chart was not split, adds the seams and returns the number of splits.
std::uint32_t splitByShape(const SeamMesh& mesh, const CutSurface& surface,
                           const PathForest& forest, const std::vector<double>& u,
                           const ShapeOptions& options, std::vector<SplitFor>& asked, Seams& seams);

}  // namespace abflat
