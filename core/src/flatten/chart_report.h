#pragma once

#include <string>

#include "abflat/flatten.h"
#include "boundary/chart_flattener.h"

namespace abflat {

/// Everything there is to say about a chart's layout.
ChartReport makeChartReport(const DiskChart& chart, const Attempt& attempt, double t);

/// Why the layout is not valid, one sentence; empty when it is.
std::string findProblem(const DiskChart& chart, const Attempt& attempt);

/// "the layout exceeds 3 of the bounds asked for, by up to 0.5 pi".
std::string exceededText(const Exceeded& exceeded);

/// What is measured of a layout whose bounds and solution are known.
void setMeasures(ChartReport& report, const Validity& validity, const Distortion& distortion);

}  // namespace abflat
