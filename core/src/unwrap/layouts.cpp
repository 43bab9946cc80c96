#include "unwrap/layouts.h"

#include <algorithm>
#include <atomic>
#include <cstdio>

#include "base/stable_order.h"

namespace abflat {
namespace {

/// Charts by size, the largest first, so that what takes longest starts first.
std::vector<std::uint32_t> largestFirst(const ChartSet& charts) {
  return stableOrder(charts.size(), [&](std::uint32_t a, std::uint32_t b) {
    return charts.topology(ChartId(a)).triangleCount() >
           charts.topology(ChartId(b)).triangleCount();
  });
}

/// Whether nothing but seams limits how little charts are stretched.
bool isFree(const UnwrapOptions& options) { return options.t == kAutoT && !options.straightSeams; }

}  // namespace

bool canCut(const UnwrapOptions& options) { return options.seams.isAuto && isFree(options); }

void flattenAll(const IdVector<ChartId, ChartWishes>& wishes, const UnwrapOptions& options,
                ThreadPool& pool, const Monitor& monitor, const std::function<bool(double)>& tell,
                LaidCharts& charts) {
  const ChartSet& set = charts.set;
  FlatCharts& flat = charts.flat;
  const std::vector<std::uint32_t> order = largestFirst(set);
  std::size_t triangles = 0;
  // Seams are only found for charts without pins.
  const auto patienceFor = [&](const ChartWishes& w) {
    return canCut(options) && w.pins.empty() ? Patience::Little : Patience::All;
  };
  const auto isKnown = [&](ChartId i) {
    return !flat[i].unpacked.empty() && (wishes[i].pins.empty() || flat[i].isFixed);
  };
  for (const ChartId i : set.ids())
    if (!isKnown(i)) triangles += set.topology(i).triangleCount();
  std::atomic<std::size_t> done{0};
  parallelFor(&pool, set.size(), [&](std::size_t k) {
    if (monitor.stopped()) return;
    const ChartId i(order[k]);
    FlatChart& out = flat[i];
    if (isKnown(i)) return;
    const DiskChart chart = set.chart(i);
    // Progress of all charts is reported, but only from the caller's own thread.
    const auto goesOn = [&] {
      if (!pool.isOwner()) return !monitor.stopped();
      return tell(static_cast<double>(done) / static_cast<double>(triangles));
    };
    const bool isCutEnough = out.isCutEnough;
    out = flattenOne(chart, options, wishes[i],
                     isCutEnough ? Patience::All : patienceFor(wishes[i]), pool, goesOn);
    out.isCutEnough = isCutEnough;
    done += chart.triangleCount();
  });
}

bool isStretched(const FlatChart& chart, double most) {
  return !chart.isFixed && chart.distortion.symmetricDirichlet > most;
}

IdVector<ChartId, std::uint8_t> stretchedPieces(const FlatCharts& flat, double most) {
  IdVector<ChartId, std::uint8_t> out;
  out.reserve(flat.size());
  for (const FlatChart& chart : flat) out.push_back(!chart.isCutEnough && isStretched(chart, most));
  return out;
}

bool dropTangled(FlatCharts& flat) {
  bool isAny = false;
  for (FlatChart& chart : flat) {
    if (!chart.isTangled || !chart.isCutEnough) continue;
    chart = {};
    chart.isCutEnough = isAny = true;
  }
  return isAny;
}

void noteStretched(const FlatCharts& flat, const UnwrapOptions& options,
                   std::vector<std::string>& notes) {
  if (!options.seams.isAuto) return;
  std::size_t count = 0;
  double most = 0;
  for (const FlatChart& chart : flat) {
    if (!isStretched(chart, options.maxStretch)) continue;
    ++count;
    most = std::max(most, chart.distortion.symmetricDirichlet);
  }
  if (count == 0) return;
  char text[120];
  std::snprintf(text, sizeof text, "%zu %s stretched by more than %g, up to %.5g: ", count,
                count == 1 ? "chart is" : "charts are", options.maxStretch, most);
  notes.push_back(text + std::string(isFree(options) ? "no seam that was tried helps enough"
                                     : options.straightSeams
                                         ? "straight seams force that"
                                         : "a larger t, or auto, stretches less"));
}

}  // namespace abflat
