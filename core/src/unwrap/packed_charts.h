#pragma once

#include "base/parallel.h"
#include "chart/chart_set.h"
#include "pack/pack.h"
#include "unwrap/chart.h"

namespace abflat {

/// The charts of a run, their layouts and where these are in the atlas.
struct PackedCharts {
  const ChartSet& set;
  double unit;  ///< what a length of 1 is in the mesh
  ThreadPool& pool;
  FlatCharts& flat;
  Packing& packing;
};

}  // namespace abflat
