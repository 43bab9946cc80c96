#include "angle/angle_problem.h"

#include <algorithm>
#include <limits>

#include "base/constants.h"
#include "mesh/triangle_geometry.h"

namespace abflat {
namespace {

constexpr double kUnbounded = std::numeric_limits<double>::infinity();
constexpr std::size_t kGrain = 2048;  ///< triangles that are one piece of work

/// What the angles of the triangles that fill holes weigh, by those of the surface: little, so that
/// a hole takes the shape it wants. Where still less would change anything Newton's method takes
/// twice the steps or stalls.
constexpr double kFillingWeight = 0.1;

/// Targets round an interior vertex sum to 2 pi. At the rim of a hole it is what fills the hole
/// that gives way first, down to a share of its own angles. `corners` are those of the surface.
void scaleTargets(std::size_t corners, AngleProblem& p) {
  constexpr double kLeast = 0.1;
  std::vector<double> sum(p.vertexCount(), 0), filling(p.vertexCount(), 0);
  for (std::size_t c = 0; c < p.target.size(); ++c)
    (c < corners ? sum : filling)[p.vertexOfCorner[c]] += p.target[c];
  p.weight.resize(p.target.size());
  for (std::size_t c = 0; c < p.target.size(); ++c) {
    const std::uint32_t v = p.vertexOfCorner[c];
    const bool isFilling = c >= corners;
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
  p.place = chart.place;
  p.isBoundary.assign(chart.vertexCount(), 0);
  for (std::uint32_t h : chart.boundary) p.isBoundary[chart.vertexOfCorner[h]] = 1;
  p.isStraight.assign(chart.vertexCount(), 0);
  p.angleSum.resize(chart.vertexCount());
  for (std::size_t v = 0; v < p.angleSum.size(); ++v)
    p.angleSum[v] = p.isBoundary[v] ? kUnbounded : 2 * kPi;

  p.target.resize(p.vertexOfCorner.size());
  parallelRanges(pool, p.triangleCount(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) {
      const std::array<double, 3> alpha =
          anglesOrMadeUp(chart.positions, &chart.vertexOfCorner[3 * f], chart.angles[f]);
      std::copy(alpha.begin(), alpha.end(), &p.target[3 * f]);
    }
  });
  scaleTargets(3 * static_cast<std::size_t>(chart.surfaceTriangles()), p);
  return p;
}

void setBounds(AngleProblem& problem, const DiskChart& chart, const std::vector<double>& t) {
  for (std::size_t i = 0; i < chart.boundary.size(); ++i)
    problem.angleSum[chart.vertexOfCorner[chart.boundary[i]]] = t[i] < 2 ? t[i] * kPi : kUnbounded;
}

void setStraight(AngleProblem& problem, const DiskChart& chart,
                 const std::vector<std::uint8_t>& straight) {
  for (std::size_t i = 0; i < straight.size(); ++i) {
    const std::uint32_t v = chart.vertexOfCorner[chart.boundary[i]];
    problem.isStraight[v] = straight[i];
    if (straight[i] != 0) problem.angleSum[v] = kPi;
  }
}

void setDelaunay(AngleProblem& problem, const DiskChart& chart, double margin) {
  problem.edgeLimit = kPi - margin;
  problem.edgeCorners.clear();
  problem.edgeOfCorner.assign(chart.twin.size(), kNone);
  for (std::uint32_t h = 0; h < chart.twin.size(); ++h) {
    const std::uint32_t twin = chart.twin[h];
    if (twin == kNone || twin < h) continue;
    const auto edge = static_cast<std::uint32_t>(problem.edgeCorners.size());
    problem.edgeCorners.push_back({prevCorner(h), prevCorner(twin)});
    for (const std::uint32_t c : problem.edgeCorners.back()) problem.edgeOfCorner[c] = edge;
  }
}

}  // namespace abflat
