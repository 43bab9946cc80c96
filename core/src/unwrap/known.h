#pragma once

#include <vector>

#include "abflat/unwrap.h"
#include "base/parallel.h"
#include "unwrap/chart.h"
#include "unwrap/cut_mesh.h"
#include "unwrap/triangle_order.h"

namespace abflat {

/// The problem of a chart that stays where it is and is not valid there.
constexpr const char* kWrongInPlace =
    "where it stays, triangles are flipped or its boundary crosses itself";

/// Where the triangles of the surface are among the known ones. Errors: InvalidOption if the known
/// layout is of another mesh.
Result<TriangleOrder> knownTriangles(const KnownLayout& known, const SurfaceMap& map);

/// Gives each chart without a layout the one in `options.reuse.known`, if that is valid and as
/// asked, apart from pins. Errors: InvalidOption if the known layout is of another mesh.
Status takeKnown(const CutMesh& mesh, const IdVector<ChartId, ChartConstraints>& constraints,
                 const UnwrapOptions& options, ThreadPool& pool, FlatCharts& flat);

}  // namespace abflat
