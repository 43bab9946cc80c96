#include "unwrap/rectify.h"

#include "base/point2.h"
#include "flatten/rectify_chart.h"
#include "solve/factor_memory.h"

namespace abflat {
namespace {

/// In terms of stretch: an outline that becomes level.
constexpr double kWorth = 0.02;

bool isAsked(const FlatChart& flat, Rectify how) {
  constexpr double kExact = 1e-6;
  const bool isExact = flat.distortion.symmetricDirichlet <= 1 + kExact;
  return flat.problem.empty() && !flat.isFixed && !flat.isGiven && !flat.unpacked.empty() &&
         flat.solver != Solver::Known && (how == Rectify::Always || !isExact);
}

void rectifyOne(const ChartSet& set, ChartId i, const UnwrapOptions& options,
                const RectifyOptions& how, FlatChart& flat) {
  IdVector<ChartVertex, ChartVertex> former;
  const DiskChart ordered = set.chartInOrder(i, former);
  std::vector<double> uv(flat.unpacked.size());
  for (const ChartVertex v : former.ids()) setPoint(uv, v, pointAt(flat.unpacked, former[v]));
  Rectified found = rectified(ordered, inChartUnit(ordered, std::move(uv)), how);
  if (found.uv.empty()) return;
  for (double& x : found.uv) x *= ordered.unit;
  std::vector<double> places(found.uv.size());
  for (const ChartVertex v : former.ids()) setPoint(places, former[v], pointAt(found.uv, v));
  const DiskChart chart = set.chart(i);
  const ChartDistortion distortion(measureDistortion(chart, inChartUnit(chart, places)));
  const double more = distortion.symmetricDirichlet - flat.distortion.symmetricDirichlet;
  const bool isWorth =
      distortion.symmetricDirichlet <= options.maxStretch && more <= kWorth * found.gain;
  if (options.rectify == Rectify::Auto && !isWorth) return;
  flat.unpacked = std::move(places);
  flat.distortion = distortion;
}

}  // namespace

void rectifyAll(const UnwrapOptions& options, ThreadPool& pool,
                const std::function<bool()>& goesOn, LaidCharts& charts) {
  const bool isFree = options.t == kAutoT && !options.straightSeams && options.balance > 0;
  if (options.rectify == Rectify::Never || !isFree) return;
  RectifyOptions how;
  how.balance = options.balance;
  how.allowedBytes = allowedBytes(options.memory);
  how.pool = &pool;
  how.onStep = [&] { return !pool.isOwner() || goesOn(); };
  parallelFor(&pool, charts.set.size(), [&](std::size_t k) {
    const ChartId i(k);
    if (isAsked(charts.flat[i], options.rectify))
      rectifyOne(charts.set, i, options, how, charts.flat[i]);
  });
}

}  // namespace abflat
