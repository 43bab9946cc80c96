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

/// The charts of a surface that are to be split.
struct SplitCharts {
  IdVector<CutChartId, SplitFor> asked;
  IdVector<CutChartId, Shape> shape;  ///< of those for which that is not Nothing
};

/// Of the charts that a split is `asked` of those that need one, as the log-scale tells their
/// shape.
SplitCharts chartsToSplit(const SeamMesh& mesh, const CutSurface& surface, const LogScales& u,
                          const ShapeOptions& options, IdVector<CutChartId, SplitFor> asked);

/// Splits charts until the layout told by `u`, cut along the new seams as it lies, has no piece
/// that covers too much of itself or too little of its convex hull. `paths` are those of these
/// charts. Leaves Nothing for a chart that was not split, adds the seams and returns the number of
/// splits.
std::uint32_t splitByShape(const CutPaths& paths, const LogScales& u, const ShapeOptions& options,
                           SplitCharts& charts, Seams& seams, const Pulse& pulse = {});

}  // namespace abflat
