#pragma once

#include <vector>

#include "chart/disk_chart.h"
#include "check/crossings.h"

namespace abflat {

/// The resolution at which parts of an outline count as touching: a millionth of its extent, as a
/// power of two. Single precision resolves more. 0 if the outline has no extent.
double contactCell(const DiskChart& chart, const std::vector<double>& uv);

/// Crossings of an outline that is a cell wider, so that parts less than a cell apart count,
/// however the layout is turned. Edges are numbered along chart.boundary.
Crossings findContacts(const DiskChart& chart, const std::vector<double>& uv);

}  // namespace abflat
