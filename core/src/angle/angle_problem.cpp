#include "angle/angle_problem.h"

#include <algorithm>
#include <limits>

#include "angle/constants.h"
#include "mesh/triangle_geometry.h"

namespace abflat {
namespace {

constexpr double kUnbounded = std::numeric_limits<double>::infinity();
constexpr std::size_t kGrain = 2048;  ///< triangles that are one piece of work

}  // namespace

AngleProblem buildAngleProblem(const DiskChart& chart, ThreadPool* pool) {
  AngleProblem p;
  p.vertexOfCorner = chart.vertexOfCorner;
  p.place = chart.place;
  p.isBoundary.assign(chart.vertexCount(), 0);
  for (std::uint32_t h : chart.boundary) p.isBoundary[chart.vertexOfCorner[h]] = 1;
  p.angleSum.resize(chart.vertexCount());
  for (std::size_t v = 0; v < p.angleSum.size(); ++v)
    p.angleSum[v] = p.isBoundary[v] ? kUnbounded : 2 * kPi;

  p.target.resize(p.vertexOfCorner.size());
  parallelRanges(pool, p.triangleCount(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) {
      const std::array<double, 3> alpha = anglesOrMadeUp(chart.angles[f]);
      std::copy(alpha.begin(), alpha.end(), &p.target[3 * f]);
    }
  });
  std::vector<double> sum(chart.vertexCount(), 0);
  for (std::size_t c = 0; c < p.target.size(); ++c) sum[p.vertexOfCorner[c]] += p.target[c];
  p.weight.resize(p.target.size());
  for (std::size_t c = 0; c < p.target.size(); ++c) {
    const std::uint32_t v = p.vertexOfCorner[c];
    if (!p.isBoundary[v]) p.target[c] *= 2 * kPi / sum[v];
    p.weight[c] = 1 / (p.target[c] * p.target[c]);
  }
  return p;
}

void setBounds(AngleProblem& problem, const DiskChart& chart, const std::vector<double>& t) {
  for (std::size_t i = 0; i < chart.boundary.size(); ++i)
    problem.angleSum[chart.vertexOfCorner[chart.boundary[i]]] = t[i] < 2 ? t[i] * kPi : kUnbounded;
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
