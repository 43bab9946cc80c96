#pragma once

#include <vector>

#include "pin/chart_pins.h"
#include "unwrap/fixed.h"

namespace abflat {

/// What is asked of each chart; fixed charts get nothing but their pins. Errors: those of
/// pinsOfCharts.
Result<IdVector<ChartId, ChartConstraints>> chartConstraints(const CutMesh& mesh,
                                                             const Texcoords& texcoords,
                                                             const FixedTriangles& fixed,
                                                             const UnwrapOptions& options);

/// Charts given by the input must not be pinned elsewhere.
Status checkUnpinned(const ChartSet& charts, const IdVector<ChartId, ChartConstraints>& constraints,
                     const FlatCharts& flat);

/// Charts with pins must be inside the unit square and must not overlap, nor lie on charts that
/// keep their place unless `options` allow it. Errors: InvalidOption, naming a vertex or two faces.
Status checkPinned(const CutMesh& mesh, const UnwrapOptions& options, const FlatCharts& flat);

}  // namespace abflat
