#pragma once

#include "chart/chart_set.h"
#include "unwrap/chart.h"

namespace abflat {

/// Names what each chart looks like in the atlas.
void nameShapes(const ChartSet& set, FlatCharts& flat);

}  // namespace abflat
