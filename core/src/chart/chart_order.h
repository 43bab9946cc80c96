#pragma once

#include "chart/disk_chart.h"

namespace abflat {

/// The same chart, numbered along a walk that depends on its shape alone, not on its numbers or on
/// the rest of the mesh. `former`: the number that each vertex had. Leaves out what placeChart
/// sets.
DiskChart walkedThrough(const DiskChart& chart, IdVector<ChartVertex, ChartVertex>& former);

}  // namespace abflat
