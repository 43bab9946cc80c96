#pragma once

#include "unwrap/laid_charts.h"
#include "unwrap/open_surface.h"

namespace abflat {

/// A surface that is cut, and its flat charts.
struct FlatCut {
  OpenSurface open;
  LaidCharts charts;
  IdVector<ChartId, ChartConstraints> constraints;  ///< on the charts
  IdVector<SurfaceTriangle, double> hidden;  ///< see occlusion(); empty until it is asked for
  bool isGivenUp = false;  ///< some charts have no layout, since others are better anyway
};

}  // namespace abflat
