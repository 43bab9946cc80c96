#pragma once

#include <vector>

#include "base/listener.h"
#include "base/parallel.h"
#include "chart/disk_chart.h"
#include "flatten/level_runs.h"

namespace abflat {

struct RectifyOptions {
  double balance = 0;  ///< see BalancedEnergy
  LevelLimits limits;
  std::uint64_t allowedBytes = 0;
  ThreadPool* pool = nullptr;
  Listener listener;  ///< told of each step
};

struct Rectified {
  std::vector<double> uv;  ///< in the chart's unit, at its area; empty: stays as it was
  double gain = 0;         ///< share of the outline that has become straight and level
  std::size_t runs = 0;    ///< how many parts that are, or would have been
};

/// Makes parts of a valid layout's outline that are nearly straight exactly so, and level: a strip
/// becomes a rectangle. Nothing changes if there is little to straighten, or if the layout would
/// not be valid.
Rectified rectified(const DiskChart& chart, const std::vector<double>& uv,
                    const RectifyOptions& options);

}  // namespace abflat
