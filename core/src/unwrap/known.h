#pragma once

#include <vector>

#include "abflat/unwrap.h"
#include "base/parallel.h"
#include "chart/chart_set.h"
#include "mesh/welded_mesh.h"
#include "unwrap/chart.h"
#include "unwrap/output.h"

namespace abflat {

/// A mesh and the charts it has been cut into.
struct CutMesh {
  const PolygonMesh& input;
  const WeldedMesh& welded;
  const Surface& surface;
  const ChartSet& set;
};

/// Where triangles of the surface are in what is known. Errors: InvalidOption where that is not
/// about this mesh.
Result<TriangleOrder> knownTriangles(const KnownLayout& known, const PolygonMesh& input,
                                     const WeldedMesh& welded, const Surface& surface);

/// Gives charts without a layout the one that `options.known` has for them, where that is valid and
/// as wished, pins aside. Errors: InvalidOption where what is known is not about this mesh.
Status takeKnown(const CutMesh& mesh, const std::vector<ChartWishes>& wishes,
                 const UnwrapOptions& options, ThreadPool& pool, std::vector<FlatChart>& flat);

}  // namespace abflat
