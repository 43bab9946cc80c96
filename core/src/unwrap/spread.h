#pragma once

#include "alike/find_alike.h"
#include "unwrap/laid_charts.h"
#include "unwrap/open_surface.h"

namespace abflat {

/// All charts of a surface, once those that lie on others have been added again.
struct SpreadCharts {
  LaidCharts charts;
  Seams seams;                         ///< between them
  IdVector<ChartId, ChartId> modelOf;  ///< the chart that each lies on; itself if on none
};

/// The parts of a surface that others lie on, cut and laid out.
struct Models {
  const Surface& surface;
  const OpenSurface& open;
  const LaidCharts& charts;
};

/// Cuts the whole surface as its models are cut, and puts each chart on that of its model: all
/// coordinates in the atlas are the same, bit by bit. `match`: per corner of the polygons, that of
/// its model.
SpreadCharts spread(const WeldedMesh& welded, const Surface& whole, const CornerMatch& match,
                    const Models& models);

}  // namespace abflat
