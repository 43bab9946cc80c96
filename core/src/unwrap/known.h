#pragma once

#include <vector>

#include "abflat/unwrap.h"
#include "base/parallel.h"
#include "unwrap/chart.h"
#include "unwrap/cut_mesh.h"
#include "unwrap/triangle_order.h"

namespace abflat {

/// Where triangles of the surface are in what is known. Errors: InvalidOption where that is not
/// about this mesh.
Result<TriangleOrder> knownTriangles(const KnownLayout& known, const SurfaceMap& map);

/// Gives charts without a layout the one that `options.known` has for them, where that is valid and
/// as wished, pins aside. Errors: InvalidOption where what is known is not about this mesh.
Status takeKnown(const CutMesh& mesh, const IdVector<ChartId, ChartWishes>& wishes,
                 const UnwrapOptions& options, ThreadPool& pool, FlatCharts& flat);

}  // namespace abflat
