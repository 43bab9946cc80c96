#pragma once

#include "chart/chart_set.h"
#include "unwrap/chart.h"

namespace abflat {

/// Charts and the layout of each, empty if there is none yet.
struct LaidCharts {
  ChartSet set;
  FlatCharts flat;
};

}  // namespace abflat
