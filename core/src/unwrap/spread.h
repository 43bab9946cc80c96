#pragma once

#include "unwrap/packed_charts.h"
#include "unwrap/stacks.h"

namespace abflat {

/// All charts of a surface, once those that lie on others have been added again.
struct SpreadCharts {
  LaidCharts charts;
  Seams seams;                         ///< between them
  IdVector<ChartId, ChartId> modelOf;  ///< the chart that each lies on; itself if on none
};

/// Cuts the whole surface as its models are cut, and puts each chart on that of its model: all
/// coordinates in the atlas are the same, bit by bit. `surface`, `open` and `charts` are those of
/// the models.
SpreadCharts spread(const WeldedMesh& welded, const Stacks& stacks, const Surface& surface,
                    const OpenSurface& open, const LaidCharts& charts);

}  // namespace abflat
