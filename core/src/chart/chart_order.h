#pragma once

#include "chart/disk_chart.h"

namespace abflat {

/// The same chart, numbered along a walk that begins where elimination ranks are lowest. `former`:
/// the number that each vertex had. Leaves out what placeChart sets.
DiskChart walkedThrough(const DiskChart& chart, IdVector<ChartVertex, ChartVertex>& former);

}  // namespace abflat
