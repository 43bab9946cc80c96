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
std::vector<double> edgeLengths(const DiskChart& chart) {
  std::vector<double> length;
  double shortest = std::numeric_limits<double>::infinity();
  for (std::uint32_t h = 0; h < chart.twin.size(); ++h) {
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
  const std::vector<double> angle = drawableAngles(chart), length = edgeLengths(chart);
  HalfEdgeWeights out{std::vector<double>(chart.twin.size(), 0), false};
  for (std::uint32_t h = 0; h < chart.twin.size(); ++h) {
    if (chart.twin[h] == kNone) continue;  // its first vertex is not interior
    const double beside = angle[nextCorner(chart.twin[h])];
    out.weight[h] = (tangent(angle[h] / 2) + tangent(beside / 2)) / length[h];
  }
  return out;
}

HalfEdgeWeights harmonicWeights(const DiskChart& chart) {
  const std::vector<double> angle = drawableAngles(chart);
  HalfEdgeWeights out{std::vector<double>(chart.twin.size(), 0), true};
  for (std::uint32_t h = 0; h < chart.twin.size(); ++h) {
    const double half = cotangent(angle[prevCorner(h)]) / 2;
    out.weight[h] += half;
    if (chart.twin[h] != kNone) out.weight[chart.twin[h]] += half;
  }
  return out;
}

}  // namespace abflat
