#pragma once

#include <cstdint>
#include <vector>

#include "mesh/ids.h"

namespace abflat {

/// An edge of the outline that should lie along an axis.
struct LevelEdge {
  ChartVertex from, to;
  std::uint8_t across = 0;  ///< the coordinate that should be the same at both: 0 for u, 1 for v
  double length = 0;        ///< on the surface
};

/// Edges that should lie along an axis, held by springs.
struct LevelEdges {
  std::vector<LevelEdge> edges;
  double stiffness = 0;  ///< energy per square of the slope, if all edges had that slope
};

}  // namespace abflat
