#include "unwrap/rectify.h"

#include <utility>

#include "base/constants.h"
#include "base/point2.h"
#include "flatten/rectify_chart.h"
#include "mesh/triangle_geometry.h"
#include "solve/factor_memory.h"
#include "unwrap/expected_density.h"
#include "unwrap/near_parts.h"
#include "unwrap/reordered.h"
#include "unwrap/stretch.h"

namespace abflat {
namespace {

/// In terms of stretch: an outline that becomes level.
constexpr double kWorth = 0.025;

bool mayChange(const FlatChart& flat) {
  return flat.problem.empty() && !flat.isFixed && !flat.isGiven && !flat.unpacked.empty() &&
         flat.solver != Solver::Known;
}

/// Whether an outline that becomes level gains anything. In a speck nobody sees it.
bool isAsked(const FlatChart& flat, Rectify how, double density) {
  if (how == Rectify::Always) return mayChange(flat);
  constexpr double kExact = 1e-6, kSpeckTexels = 64;
  const bool isExact = flat.distortion.symmetricDirichlet <= 1 + kExact;
  return mayChange(flat) && !isExact && flat.area * density * density > kSpeckTexels;
}

/// How many edges of the outline would come too near others, so that the chart would be cut there.
/// None of one that is many tiles long, which packing refuses or makes much smaller.
std::size_t nearEdges(const DiskChart& chart, const std::vector<double>& unpacked, double density,
                      const UnwrapOptions& options) {
  const double most = 16.0 * options.resolution.longer();
  const Point2 first = pointAt(unpacked, chart.vertexOfCorner[chart.boundary.front()]);
  PlacedOutline outline;
  for (const ChartCorner h : chart.boundary) {
    const ChartVertex v = chart.vertexOfCorner[h];
    const Point2 at = pointAt(unpacked, v);
    if (!(density * norm(at[0] - first[0], at[1] - first[1]) <= most)) return 0;
    for (const double x : at) outline.uv.push_back(density * x);
    for (std::size_t d = 0; d < 3; ++d)
      outline.positions.push_back(density * chart.unit * chart.positions[3 * std::size_t{v} + d]);
  }
  return findNearParts(outline, options.padding).edges.size();
}

/// Whether the chart takes the places that its outline would have.
bool take(const DiskChart& chart, std::vector<double> places, double gain,
          const UnwrapOptions& options, double density, FlatChart& flat) {
  if (!scaleToSurface(chart, places)) return false;
  const ChartDistortion distortion(measureDistortion(chart, inChartUnit(chart, places)));
  const double more = distortion.symmetricDirichlet - flat.distortion.symmetricDirichlet;
  constexpr double kNoLeeway = 1;  // that is for what would be cut otherwise
  const bool isWorth =
      stretchOf(distortion, kNoLeeway, options) <= options.maxStretch && more <= kWorth * gain;
  if (options.rectify == Rectify::Auto && !isWorth) return false;
  if (nearEdges(chart, places, density, options) >
      nearEdges(chart, flat.unpacked, density, options))
    return false;
  flat.unpacked = std::move(places);
  flat.distortion = distortion;
  return true;
}

/// What to try in turn: where some sides cannot become straight, straighter ones may. That takes
/// little time for small charts; of large ones only what is likely to be worth it is tried.
std::vector<LevelLimits> limitsFor(const DiskChart& chart) {
  constexpr std::uint32_t kSmall = 20000;
  constexpr double kDegree = kPi / 180;
  if (chart.triangleCount() > kSmall) return {{0.4, 10 * kDegree}};
  return {{0.25, 20 * kDegree}, {0.25, 12 * kDegree}, {0.25, 7 * kDegree}};
}

void rectifyOne(const ChartSet& set, ChartId i, const UnwrapOptions& options, RectifyOptions how,
                double density, FlatChart& flat) {
  IdVector<ChartVertex, ChartVertex> former;
  const DiskChart ordered = set.chartInOrder(i, former);
  const std::vector<double> before = inChartUnit(ordered, inOrder(flat.unpacked, former));
  std::size_t runs = 0;
  for (const LevelLimits& limits : limitsFor(ordered)) {
    how.limits = limits;
    Rectified found = rectified(ordered, before, how);
    if (found.runs == 0) return;
    if (found.runs == std::exchange(runs, found.runs) || found.uv.empty()) continue;
    for (double& x : found.uv) x *= ordered.unit;
    if (take(set.chart(i), inFormerOrder(found.uv, former), found.gain, options, density, flat))
      return;
  }
}

}  // namespace

void rectifyAll(const UnwrapOptions& options, double unit, ThreadPool& pool,
                const Listener& listener, LaidCharts& charts) {
  const bool isFree = options.t == kAutoT && !options.straightSeams && options.balance > 0;
  if (options.rectify == Rectify::Never || !isFree) return;
  RectifyOptions how;
  how.balance = options.balance;
  how.allowedBytes = allowedBytes(options.memory);
  how.pool = &pool;
  double area = 0;
  for (const FlatChart& chart : charts.flat) area += chart.area;
  const double density = expectedDensity(options, area, unit);
  how.listener = listener;
  parallelFor(&pool, charts.set.size(), [&](std::size_t k) {
    const ChartId i(k);
    if (isAsked(charts.flat[i], options.rectify, density))
      rectifyOne(charts.set, i, options, how, density, charts.flat[i]);
  });
}

}  // namespace abflat
