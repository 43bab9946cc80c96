#include "layout/tutte.h"

namespace abflat {

Embedding embedTutte(const DiskChart& chart) {
  const HalfEdgeWeights ones{IdVector<ChartCorner, double>(chart.twin.size(), 1), true};
  return embedByWeights(chart, ones, boundaryOnCircle(chart));
}

}  // namespace abflat
