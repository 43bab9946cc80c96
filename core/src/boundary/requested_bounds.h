#pragma once

#include <vector>

#include "abflat/flatten_options.h"
#include "abflat/status.h"
#include "boundary/straight_runs.h"
#include "chart/disk_chart.h"

namespace abflat {

/// The bounds that the options ask for; kAutoT counts as 2. They have no effect where `straight`
/// holds the angle at pi. Errors: InvalidOption for a bound of a vertex that is not on the
/// boundary; InfeasibleBound.
Result<BoundaryBounds> requestedBounds(const DiskChart& chart, const FlattenOptions& options,
                                       const StraightPlaces& straight);

/// Bounds below 2 by vertex of the chart, as stored in results, and the reverse.
std::vector<VertexBound> vertexBounds(const DiskChart& chart, const BoundaryBounds& t);
BoundaryBounds boundsOf(const DiskChart& chart, const std::vector<VertexBound>& bounds);

}  // namespace abflat
