#include "unwrap/search.h"

#include <utility>

#include "seam/vary_costs.h"
#include "unwrap/cut_open.h"
#include "unwrap/known.h"
#include "unwrap/layouts.h"
#include "unwrap/pieces.h"
#include "unwrap/small_charts.h"
#include "unwrap/variants.h"

namespace abflat {
namespace {

Status cutAgain(const SearchInput& input, const SeamVariant& variant, const CutFlattener& flattener,
                FlatCut& cut) {
  const FlattenSettings& with = flattener.settings();
  SeamSummary summary;  // that of the first search holds
  with.times.book(&UnwrapStages::solve);
  cut.open =
      cutOpen(input.uncut, input.asked, variant, with.options, with.pool, with.listener, summary);
  with.times.book(&UnwrapStages::seams);
  if (with.listener.isStopped()) return {};
  if (Status s = flattener.takeCharts(cut); !s.ok()) return s;
  return flattener.flatten(cut);
}

/// Cuts the surface in other ways, too, and keeps what turns out best.
Status tryOthers(const SearchInput& input, const std::vector<SeamVariant>& variants,
                 const CutFlattener& flattener, FlatCut& best) {
  constexpr int kMostFruitless = 3;
  const FlattenSettings& with = flattener.settings();
  int fruitless = isSettled(with.options, best) ? kMostFruitless : 0;
  for (SeamVariant variant : variants) {
    if (fruitless >= kMostFruitless && !variant.isTighter) continue;
    FlatCut other;
    variant.before = &best.open;
    if (Status s = cutAgain(input, variant, flattener, other); !s.ok()) return s;
    if (with.listener.isStopped()) break;
    const bool isBetter = takeBetter(input.uncut.welded, with.options, best, other);
    if (!isForFront(variant.costs)) fruitless = isBetter ? 0 : fruitless + 1;
  }
  return {};
}

/// Joins charts that are too small to be worth a seam, where the bounds allow it.
Status joinSmall(const CutFlattener& flattener, FlatCut& cut) {
  constexpr int kMostRounds = 6;
  const FlattenSettings& with = flattener.settings();
  SmallCharts small;
  for (int k = 0; k < kMostRounds && canCut(with.options) && !with.listener.isStopped(); ++k) {
    const Seams seams = small.join(cut.charts, with.options, cut.open);
    if (seams.empty()) break;
    LaidCharts before;
    if (Status s = flattener.takeChartsAnew(cut, before); !s.ok()) return s;
    if (Status s = flattener.layOut(cut); !s.ok()) return s;
    if (with.listener.isStopped()) break;
    const IdVector<ChartId, std::uint8_t> isRefused =
        small.refused(before, cut.charts, with.options, cut.open.mirror);
    if (Status s = flattener.takeBack(before, isRefused, seams, cut); !s.ok()) return s;
  }
  return {};
}

/// Charts that pins and what is known say nothing about keep their layout.
Status layOutAsAsked(const CutFlattener& flattener, FlatCut& cut) {
  const FlattenSettings& with = flattener.settings();
  LaidCharts solved = std::move(cut.charts);
  if (Status s = flattener.takeCharts(cut); !s.ok()) return s;
  if (Status s = takeKnown({with.map, cut.charts.set}, cut.constraints, with.options, with.pool,
                           cut.charts.flat);
      !s.ok())
    return s;
  for (const ChartId i : cut.charts.set.ids())
    if (!cut.constraints[i].pins.empty()) solved.flat[i] = FlatChart();
  moveSame(solved, cut.charts);
  return flattener.flatten(cut);
}

}  // namespace

Status searchMore(const SearchInput& input, const std::vector<SeamVariant>& variants,
                  const FlattenSettings& settings, FlatCut& cut) {
  FlattenSettings searching = settings;
  searching.isSearch = true;
  const CutFlattener flattener(std::move(searching));
  if (Status s = tryOthers(input, variants, flattener, cut); !s.ok()) return s;
  if (Status s = joinSmall(flattener, cut); !s.ok()) return s;
  return settings.listener.isStopped() ? Status() : layOutAsAsked(CutFlattener(settings), cut);
}

}  // namespace abflat
