#pragma once

#include "base/parallel.h"
#include "pack/pack.h"
#include "unwrap/laid_charts.h"

namespace abflat {

/// The charts of a run, and their places in the atlas.
struct PackedCharts {
  double unit;                           ///< what a length of 1 is in the mesh
  const std::vector<double>& positions;  ///< of the mesh's vertices
  std::size_t upAxis;                    ///< of these, which points up
  ThreadPool& pool;
  LaidCharts& charts;
  Packing& packing;
  IdVector<ChartId, double> densities;  ///< relative to each other; empty: 1 each

  double density(ChartId i) const { return densities.empty() ? 1 : densities[i]; }
};

}  // namespace abflat
