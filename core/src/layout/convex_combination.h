#pragma once

#include <string>
#include <vector>

#include "chart/disk_chart.h"

namespace abflat {

/// uv, 2 per chart vertex, and why it is of no use: one sentence, empty when it can be used.
struct Embedding {
  std::vector<double> uv;
  std::string problem;
};

/// Boundary vertices on a circle of the chart's area, spaced by 3D edge length (a shortest arc
/// keeps them apart), of radius 1 where there is no area; lower left corner of the circle's
/// bounding box at the origin. Interior vertices are at 0.
std::vector<double> boundaryOnCircle(const DiskChart& chart);

/// Weight of each half-edge: how much its first vertex, if interior, is drawn to its second one.
struct HalfEdgeWeights {
  IdVector<ChartCorner, double> weight;
  bool isSymmetric = false;  ///< both half-edges of an edge weigh the same
};

/// Every interior vertex at the weighted mean of its neighbours, with the boundary where `uv` has
/// it.
Embedding embedByWeights(const DiskChart& chart, const HalfEdgeWeights& weights,
                         std::vector<double> uv);

}  // namespace abflat
