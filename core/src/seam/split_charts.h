#pragma once

#include <limits>
#include <vector>

#include "seam/outline.h"
#include "seam/path_forest.h"

namespace abflat {

struct ShapeOptions {
  double leastFill = 0;    ///< relative to the convex hull
  double mostOverlap = 0;  ///< relative to the chart's area
  double longest = std::numeric_limits<double>::infinity();
};

/// The reason for splitting a chart.
enum class SplitFor : std::uint8_t { Nothing, Overlap, OverlapOrFill };

/// The charts of a surface that are to be split.
struct SplitCharts {
  IdVector<CutChartId, SplitFor> asked;
  IdVector<CutChartId, Shape> shape;  ///< of those charts that ask for something
};

/// Among the charts for which a split is `asked`, those that need one, judging by the shape that
/// the log-scale predicts.
SplitCharts chartsToSplit(const SeamMesh& mesh, const CutSurface& surface, const LogScales& u,
                          const ShapeOptions& options, IdVector<CutChartId, SplitFor> asked);

/// Splits charts until no piece of the layout predicted by `u`, cut in place along the new seams,
/// covers too much of itself or too little of its convex hull. `paths` belong to these charts. Sets
/// Nothing for charts that were not split, adds the seams and returns the number of splits.
std::uint32_t splitByShape(const CutPaths& paths, const LogScales& u, const ShapeOptions& options,
                           SplitCharts& charts, Seams& seams, const Listener& listener = {});

}  // namespace abflat
