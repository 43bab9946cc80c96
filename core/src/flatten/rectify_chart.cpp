#include "flatten/rectify_chart.h"

#include <algorithm>

#include "base/point2.h"
#include "base/portable_math.h"
#include "boundary/chart_flattener.h"
#include "layout/pose.h"
#include "mesh/triangle_geometry.h"
#include "refine/refine.h"

namespace abflat {
namespace {

void turn(double angle, std::vector<double>& uv) {
  const portable::SinCos by = portable::sinCos(angle);
  for (std::size_t i = 0; 2 * i < uv.size(); ++i) {
    const Point2 p = pointAt(uv, i);
    setPoint(uv, i, {by.cos * p[0] - by.sin * p[1], by.sin * p[0] + by.cos * p[1]});
  }
}

std::vector<LevelEdge> edgesOf(const DiskChart& chart, const std::vector<LevelRun>& runs) {
  std::vector<LevelEdge> out;
  double length = 0;
  for (const LevelRun& run : runs)
    for (BoundaryIndex i = run.from; i != run.to; i = chart.after(i)) {
      const ChartVertex a = chart.boundaryVertex(i), b = chart.boundaryVertex(chart.after(i));
      out.push_back({a, b, run.across, norm(edgeVector(chart.positions, a, b))});
      length += out.back().length;
    }
  // So that tiny edges are not stiff beyond what numbers can tell.
  constexpr double kShortest = 1e-4;
  const double least =
      kShortest * length / static_cast<double>(std::max<std::size_t>(out.size(), 1));
  for (LevelEdge& edge : out) edge.length = std::max(edge.length, least);
  return out;
}

/// Puts the vertices of each run on one line.
void level(const DiskChart& chart, const std::vector<LevelRun>& runs, std::vector<double>& uv) {
  for (const LevelRun& run : runs) {
    double sum = 0, length = 0;
    const auto place = [&](BoundaryIndex i) -> double& {
      return uv[2 * chart.boundaryVertex(i) + run.across];
    };
    for (BoundaryIndex i = run.from; i != run.to; i = chart.after(i)) {
      const Point2 a = pointAt(uv, chart.boundaryVertex(i));
      const Point2 b = pointAt(uv, chart.boundaryVertex(chart.after(i)));
      const double own = portable::hypot(b[0] - a[0], b[1] - a[1]);
      sum += own * (place(i) + place(chart.after(i))) / 2;
      length += own;
    }
    if (!(length > 0)) continue;
    for (BoundaryIndex i = run.from;; i = chart.after(i)) {
      place(i) = sum / length;
      if (i == run.to) break;
    }
  }
}

}  // namespace

Rectified rectified(const DiskChart& chart, const std::vector<double>& uv,
                    const RectifyOptions& options) {
  constexpr double kLeastGain = 0.1;  // share of the outline
  const LevelRuns found = findLevelRuns(chart, uv, options.limits);
  if (found.share - found.before < kLeastGain) return {};
  std::vector<double> now = uv;
  turn(found.turn, now);
  RefineOptions refining;
  refining.energy = Energy(options.balance);
  refining.allowedBytes = options.allowedBytes;
  refining.pool = options.pool;
  refining.listener = options.listener;
  refining.level.edges = edgesOf(chart, found.runs);
  refining.level.stiffness = 1e4;  // as few steps as a weak pull takes
  now = refine(chart, std::move(now), refining).uv;
  level(chart, found.runs, now);
  fitArea(chart, now);
  if (!checkSeparated(chart, now).valid()) return {{}, 0, found.runs.size()};
  return {std::move(now), found.share - found.before, found.runs.size()};
}

}  // namespace abflat
