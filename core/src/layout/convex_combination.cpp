#include "layout/convex_combination.h"

#include <algorithm>
#include <cmath>

#include "base/constants.h"
#include "base/point2.h"
#include "base/portable_math.h"
#include "mesh/triangle_geometry.h"
#include "solve/general_solve.h"
#include "solve/symmetric_solve.h"

namespace abflat {
namespace {

struct System {
  IdVector<ChartVertex, int> unknown;  ///< row of each interior vertex; -1 on the boundary
  SparseSystem equations;              ///< for u and for v
};

System makeSystem(const DiskChart& chart, const IdVector<ChartCorner, double>& weight,
                  const std::vector<double>& uv) {
  System s;
  s.unknown.assign(chart.vertexCount(), 0);
  for (const ChartCorner h : chart.boundary) s.unknown[chart.vertexOfCorner[h]] = -1;
  int n = 0;
  for (int& u : s.unknown)
    if (u == 0) u = n++;
  s.equations.size = n;
  const auto rows = static_cast<std::size_t>(n);
  s.equations.b.assign(2 * rows, 0);
  SparseEntries& entries = s.equations.entries;
  for (const ChartCorner h : chart.corners()) {
    // Every interior vertex begins one half-edge to each neighbour.
    const ChartVertex b = chart.vertexOfCorner[nextCorner(h)];
    const int row = s.unknown[chart.vertexOfCorner[h]];
    if (row < 0) continue;
    entries.emplace_back(row, row, weight[h]);
    if (s.unknown[b] >= 0)
      entries.emplace_back(row, s.unknown[b], -weight[h]);
    else
      for (std::size_t d = 0; d < 2; ++d)
        s.equations.b[d * rows + static_cast<std::size_t>(row)] += weight[h] * uv[2 * b + d];
  }
  return s;
}

/// Length of each boundary edge, none much shorter than the mean.
IdVector<BoundaryIndex, double> boundaryLengths(const DiskChart& chart) {
  IdVector<BoundaryIndex, double> length;
  double total = 0;
  for (const ChartCorner h : chart.boundary) {
    length.push_back(norm(
        edgeVector(chart.positions, chart.vertexOfCorner[h], chart.vertexOfCorner[nextCorner(h)])));
    total += length.back();
  }
  constexpr double kShortestArc = 0.1;  // of the mean
  const double least = kShortestArc * total / static_cast<double>(length.size());
  for (double& l : length) l = least > 0 ? std::max(l, least) : 1;
  return length;
}

/// A side of the polygon that the boundary becomes: an edge, or a straight run.
struct Side {
  BoundaryIndex from, to;
  double length;
};

/// All sides. None is longer than the others together.
std::vector<Side> sidesOf(const DiskChart& chart, const StraightPlaces& straight,
                          const IdVector<BoundaryIndex, double>& length) {
  const auto goesOn = [&](BoundaryIndex i) { return !straight.empty() && straight[i] != 0; };
  std::vector<Side> out;
  double total = 0;
  for (const BoundaryIndex i : length.ids()) {
    if (goesOn(i)) continue;
    Side side{i, chart.after(i), length[i]};
    for (; goesOn(side.to); side.to = chart.after(side.to)) side.length += length[side.to];
    total += side.length;
    out.push_back(side);
  }
  for (Side& side : out) side.length = std::min(side.length, total - side.length);
  return out;
}

/// Spaces the places within a side by length, on the line between its ends.
void spread(const DiskChart& chart, const Side& side, const IdVector<BoundaryIndex, double>& length,
            std::vector<double>& uv) {
  double whole = 0;
  for (BoundaryIndex i = side.from; i != side.to; i = chart.after(i)) whole += length[i];
  const Point2 a = pointAt(uv, chart.boundaryVertex(side.from));
  const Point2 b = pointAt(uv, chart.boundaryVertex(side.to));
  double passed = length[side.from];
  for (BoundaryIndex i = chart.after(side.from); i != side.to; i = chart.after(i)) {
    const double share = passed / whole;
    setPoint(uv, chart.boundaryVertex(i),
             {a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])});
    passed += length[i];
  }
}

}  // namespace

std::vector<double> boundaryOnCircle(const DiskChart& chart, const StraightPlaces& straight) {
  std::vector<double> uv(2 * chart.vertices().size(), 0);
  const IdVector<BoundaryIndex, double> length = boundaryLengths(chart);
  const std::vector<Side> sides = sidesOf(chart, straight, length);
  double total = 0;
  for (const Side& side : sides) total += side.length;
  const double area = surfaceArea(chart);
  const double radius = area > 0 ? std::sqrt(area / kPi) : 1;
  double passed = 0;
  for (const Side& side : sides) {
    const double angle = 2 * kPi * passed / total;
    setPoint(uv, chart.boundaryVertex(side.from),
             {radius * (1 + portable::cos(angle)), radius * (1 + portable::sin(angle))});
    passed += side.length;
  }
  for (const Side& side : sides) spread(chart, side, length, uv);
  return uv;
}

Embedding embedByWeights(const DiskChart& chart, const HalfEdgeWeights& weights,
                         std::vector<double> uv) {
  Embedding out{std::move(uv), {}};
  const System s = makeSystem(chart, weights.weight, out.uv);
  const auto rows = static_cast<std::size_t>(s.equations.size);
  if (rows == 0) return out;
  const std::vector<double> solved =
      weights.isSymmetric ? solveSymmetric(s.equations) : solveGeneral(s.equations);
  if (solved.empty() ||
      !std::all_of(solved.begin(), solved.end(), [](double x) { return std::isfinite(x); })) {
    out.problem =
        "the linear system for the interior vertices cannot be solved: its weights "
        "differ too much in size, or cancel";
    return out;
  }
  for (const ChartVertex v : chart.vertices())
    if (const int row = s.unknown[v]; row >= 0)
      setPoint(
          out.uv, v,
          {solved[static_cast<std::size_t>(row)], solved[rows + static_cast<std::size_t>(row)]});
  return out;
}

}  // namespace abflat
