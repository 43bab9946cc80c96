#pragma once

#include <vector>

#include "pin/chart_pins.h"
#include "unwrap/fixed.h"

namespace abflat {

/// What each chart is asked for; nothing but pins of those that are fixed. Errors: those of
/// pinsOfCharts.
Result<IdVector<ChartId, ChartWishes>> chartWishes(const CutMesh& mesh, const Texcoords& texcoords,
                                                   const FixedTriangles& fixed,
                                                   const UnwrapOptions& options);

/// What the input gives is not to be pinned elsewhere.
Status checkUnpinned(const ChartSet& charts, const IdVector<ChartId, ChartWishes>& wishes,
                     const FlatCharts& flat);

/// Charts with pins must be inside the unit square and not on each other. Errors: InvalidOption
/// names a vertex or two faces.
Status checkPinned(const CutMesh& mesh, const FlatCharts& flat);

}  // namespace abflat
