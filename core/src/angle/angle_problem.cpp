#include "angle/angle_problem.h"

#include <algorithm>
#include <limits>

#include "base/constants.h"
#include "mesh/triangle_geometry.h"

namespace abflat {
namespace {

constexpr double kUnbounded = std::numeric_limits<double>::infinity();
constexpr std::size_t kGrain = 2048;  ///< triangles per piece of work

/// Weight of the angles of triangles that fill holes, relative to those of the surface: low, so
/// that a hole takes the shape it wants. Where an even lower weight would make a difference,
/// Newton's method takes twice the steps or stalls.
constexpr double kFillingWeight = 0.1;

/// Makes the targets round an interior vertex sum to 2 pi. At the rim of a hole the filling gives
/// way first, down to a share of its own angles. The first `surfaceCorners` corners are those of
/// the surface.
void scaleTargets(std::size_t surfaceCorners, AngleProblem& p) {
  constexpr double kLeast = 0.1;
  IdVector<ChartVertex, double> sum(p.vertexCount(), 0), filling(p.vertexCount(), 0);
  for (const ChartCorner c : p.corners())
    (c < surfaceCorners ? sum : filling)[p.vertexOfCorner[c]] += p.target[c];
  p.weight.resize(p.target.size());
  for (const ChartCorner c : p.corners()) {
    const ChartVertex v = p.vertexOfCorner[c];
    const bool isFilling = c >= surfaceCorners;
    if (!p.isBoundary[v]) {
      const double room = std::max(2 * kPi - sum[v], kLeast * filling[v]);
      const double scale = 2 * kPi / (sum[v] + (filling[v] > 0 ? room : 0));
      p.target[c] *= isFilling ? scale * room / filling[v] : scale;
    }
    p.weight[c] = (isFilling ? kFillingWeight : 1) / (p.target[c] * p.target[c]);
  }
}

}  // namespace

AngleProblem buildAngleProblem(const DiskChart& chart, ThreadPool* pool) {
  AngleProblem p;
  p.vertexOfCorner = chart.vertexOfCorner;
  p.eliminationRank = chart.eliminationRank;
  p.isBoundary.assign(chart.vertexCount(), 0);
  for (const ChartCorner h : chart.boundary) p.isBoundary[chart.vertexOfCorner[h]] = 1;
  p.isStraight.assign(chart.vertexCount(), 0);
  p.angleSum.resize(chart.vertexCount());
  for (const ChartVertex v : p.vertices()) p.angleSum[v] = p.isBoundary[v] ? kUnbounded : 2 * kPi;

  p.target.resize(p.vertexOfCorner.size());
  parallelRanges(pool, p.triangleCount(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (const ChartTriangle f : IdRange{ChartTriangle(begin), ChartTriangle(end)}) {
      const std::array<double, 3> alpha =
          anglesOrMadeUp(chart.positions, verticesOf(chart.vertexOfCorner, f), chart.angles[f]);
      for (const ChartCorner c : cornersOf(f)) p.target[c] = alpha[placeInTriangle(c)];
    }
  });
  scaleTargets(chart.surfaceCorners().size(), p);
  return p;
}

void setBounds(AngleProblem& problem, const DiskChart& chart, const BoundaryBounds& t) {
  for (const BoundaryIndex i : chart.boundary.ids())
    problem.angleSum[chart.boundaryVertex(i)] = t[i] < 2 ? t[i] * kPi : kUnbounded;
}

void setStraight(AngleProblem& problem, const DiskChart& chart, const StraightPlaces& straight) {
  for (const BoundaryIndex i : straight.ids()) {
    const ChartVertex v = chart.boundaryVertex(i);
    problem.isStraight[v] = straight[i];
    if (straight[i] != 0) problem.angleSum[v] = kPi;
  }
}

void setDelaunay(AngleProblem& problem, const DiskChart& chart, std::optional<double> margin) {
  problem.edgeCorners.clear();
  problem.edgeOfCorner.clear();
  if (!margin) return;
  problem.edgeLimit = kPi - *margin;
  problem.edgeOfCorner.assign(chart.twin.size(), kNone);
  for (const ChartCorner h : chart.corners()) {
    const ChartCorner twin = chart.twin[h];
    if (!twin.exists() || twin < h) continue;
    const auto edge = static_cast<std::uint32_t>(problem.edgeCorners.size());
    problem.edgeCorners.push_back({prevCorner(h), prevCorner(twin)});
    for (const ChartCorner c : problem.edgeCorners.back()) problem.edgeOfCorner[c] = edge;
  }
}

}  // namespace abflat
