#pragma once

#include <string>
#include <vector>

#include "chart/disk_chart.h"

namespace abflat {

/// uv, 2 per chart vertex, and why it cannot be used: one sentence, empty if it can.
struct Embedding {
  std::vector<double> uv;
  std::string problem;
};

/// Boundary vertices on a circle of the chart's area (radius 1 if it has none), spaced by 3D edge
/// length with a shortest arc that keeps them apart; lower left corner of the circle's bounding box
/// at the origin. Straight runs are chords, at most as long as the diameter. Interior vertices are
/// at 0.
std::vector<double> boundaryOnCircle(const DiskChart& chart, const StraightPlaces& straight = {});

/// Weight of each half-edge: how strongly its first vertex, if interior, is drawn to its second.
struct HalfEdgeWeights {
  IdVector<ChartCorner, double> weight;
  bool isSymmetric = false;  ///< both half-edges of an edge have the same weight
};

/// Puts every interior vertex at the weighted mean of its neighbours, with the boundary as in `uv`.
Embedding embedByWeights(const DiskChart& chart, const HalfEdgeWeights& weights,
                         std::vector<double> uv);

}  // namespace abflat
