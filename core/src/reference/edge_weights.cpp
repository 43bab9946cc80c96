#include "reference/edge_weights.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/portable_math.h"
#include "reference/corner_angles.h"

namespace abflat {
namespace {

double tangent(double x) { return portable::sin(x) / portable::cos(x); }

/// 3D length of each half-edge. Vertices that coincide are taken to be as far apart as the closest
/// two that do not.
IdVector<ChartCorner, double> edgeLengths(const DiskChart& chart) {
  IdVector<ChartCorner, double> length;
  double shortest = std::numeric_limits<double>::infinity();
  for (const ChartCorner h : chart.corners()) {
    length.push_back(norm(
        edgeVector(chart.positions, chart.vertexOfCorner[h], chart.vertexOfCorner[nextCorner(h)])));
    if (length.back() > 0) shortest = std::min(shortest, length.back());
  }
  for (double& l : length)
    if (!(l > 0)) l = std::isfinite(shortest) ? shortest : 1;
  return length;
}

}  // namespace

HalfEdgeWeights meanValueWeights(const DiskChart& chart) {
  const IdVector<ChartCorner, double> angle = drawableAngles(chart), length = edgeLengths(chart);
  HalfEdgeWeights out{IdVector<ChartCorner, double>(chart.twin.size(), 0), false};
  for (const ChartCorner h : chart.corners()) {
    if (!chart.twin[h].exists()) continue;  // its first vertex is not interior
    const double beside = angle[nextCorner(chart.twin[h])];
    out.weight[h] = (tangent(angle[h] / 2) + tangent(beside / 2)) / length[h];
  }
  return out;
}

HalfEdgeWeights harmonicWeights(const DiskChart& chart) {
  const IdVector<ChartCorner, double> angle = drawableAngles(chart);
  HalfEdgeWeights out{IdVector<ChartCorner, double>(chart.twin.size(), 0), true};
  for (const ChartCorner h : chart.corners()) {
    const double half = cotangent(angle[prevCorner(h)]) / 2;
    out.weight[h] += half;
    if (chart.twin[h].exists()) out.weight[chart.twin[h]] += half;
  }
  return out;
}

}  // namespace abflat
