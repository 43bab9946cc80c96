#pragma once

#include <limits>
#include <vector>

#include "seam/outline.h"
#include "seam/path_forest.h"

namespace abflat {

struct ShapeOptions {
  double leastFill = 0;    ///< of the convex hull
  double mostOverlap = 0;  ///< of the chart's area
  double longest = std::numeric_limits<double>::infinity();
};

/// What a chart is split for.
enum class SplitFor : std::uint8_t { Nothing, Overlap, OverlapOrFill };

/// Shapes of the charts that need a split for what is `asked`, as the log-scale tells them. Leaves
/// Nothing in `asked` where none is needed.
std::vector<Shape> shapesToSplit(const SeamMesh& mesh, const CutSurface& surface,
                                 const std::vector<double>& u, const ShapeOptions& options,
                                 std::vector<SplitFor>& asked);

/// Splits charts for what is `asked`, which have these shapes, until the layout told by `u`, cut
/// along the new seams as it lies, has no piece that covers too much of itself or too little of its
/// convex hull. `forest` has the paths of these charts. Leaves Nothing in `asked` where a chart was
/// not split, adds the seams and returns the number of splits.
std::uint32_t splitByShape(const SeamMesh& mesh, const CutSurface& surface,
                           const PathForest& forest, const std::vector<double>& u,
                           const std::vector<Shape>& shapes, const ShapeOptions& options,
                           std::vector<SplitFor>& asked, Seams& seams, const Pulse& pulse = {});

}  // namespace abflat
