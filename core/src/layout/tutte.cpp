#include "layout/tutte.h"

namespace abflat {

Embedding embedTutte(const DiskChart& chart) { return embedTutte(chart, {}, 1); }

Embedding embedTutte(const DiskChart& chart, const StraightPlaces& straight,
                     double boundaryWeight) {
  IdVector<ChartVertex, double> pull(chart.vertexCount(), 1);
  for (const ChartCorner h : chart.boundary) pull[chart.vertexOfCorner[h]] = boundaryWeight;
  HalfEdgeWeights weights;
  weights.isSymmetric = true;  // between interior vertices, whose rows are solved
  for (const ChartCorner h : chart.corners())
    weights.weight.push_back(pull[chart.vertexOfCorner[nextCorner(h)]]);
  return embedByWeights(chart, weights, boundaryOnCircle(chart, straight));
}

}  // namespace abflat
