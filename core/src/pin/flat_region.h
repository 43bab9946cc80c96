#pragma once

#include "mesh/ids.h"

namespace abflat {

/// Triangles of a region in the plane, which may have holes.
struct FlatRegion {
  const IdVector<ChartCorner, ChartVertex>& vertexOfCorner;
  /// Half-edges of all boundary loops, in any order, with the region on their left.
  const IdVector<BoundaryIndex, ChartCorner>& boundary;
};

}  // namespace abflat
