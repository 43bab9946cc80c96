#pragma once

#include "chart/chart_set.h"
#include "mesh/surface_map.h"

namespace abflat {

/// The surface of a mesh and the charts it has been cut into.
struct CutMesh {
  SurfaceMap map;
  const ChartSet& set;
};

}  // namespace abflat
