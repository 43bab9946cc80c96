#pragma once

#include "abflat/flatten.h"
#include "boundary/chart_flattener.h"

namespace abflat {

/// Everything there is to say about a chart's layout.
ChartReport makeChartReport(const DiskChart& chart, const Attempt& attempt, double t);

/// What is measured of a layout whose bounds and solution are known.
void setMeasures(ChartReport& report, const Validity& validity, const Distortion& distortion);

}  // namespace abflat
