#pragma once

#include <string>

#include "abflat/flatten.h"
#include "boundary/chart_flattener.h"

namespace abflat {

/// The complete report of a chart's layout.
ChartReport makeChartReport(const DiskChart& chart, const Attempt& attempt, double t);

/// Why the layout is not valid, in one sentence; empty if it is valid.
std::string findProblem(const DiskChart& chart, const Attempt& attempt);

/// Names the boundary angles that miss what was asked for; empty if there are none.
std::string missedText(const MissedAngles& exceeded, const MissedAngles& bent);

/// Fills in what is measured on a layout whose bounds and solution are known.
void setMeasures(ChartReport& report, const Validity& validity, const Distortion& distortion);

}  // namespace abflat
