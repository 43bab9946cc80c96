#pragma once

#include <vector>

#include "boundary/straight_runs.h"
#include "chart/chart_set.h"

namespace abflat {

/// Of one chart.
struct StraightSeams {
  StraightPlaces places;     ///< of the boundary, where the layout goes straight on
  std::size_t released = 0;  ///< places between ends of seams that are not
};

/// Seams and boundaries from end to end, per chart. Ends are junctions, where the chart on the
/// other side changes, tips, and corners of the surface. A run that turns much on the surface stays
/// as it is, like the rim of a round lid; so does what no layout could have straight.
std::vector<StraightSeams> straightSeams(const Surface& surface, const ChartSet& set);

}  // namespace abflat
