#pragma once

#include "abflat/flatten.h"
#include "boundary/chart_flattener.h"

namespace abflat {

/// Everything there is to say about a chart's layout.
ChartReport makeChartReport(const DiskChart& chart, const Attempt& attempt, double t);

}  // namespace abflat
