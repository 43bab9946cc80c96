#include "unwrap/flatten_cut.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "unwrap/cut_stretched.h"
#include "unwrap/cuts_for_packing.h"
#include "unwrap/expect_scale.h"
#include "unwrap/halve.h"
#include "unwrap/known.h"
#include "unwrap/layouts.h"
#include "unwrap/output.h"
#include "unwrap/pieces.h"
#include "unwrap/pinned.h"
#include "unwrap/stretch.h"
#include "unwrap/variants.h"

namespace abflat {

/// Work in rounds, each of which fills a share of the bar that those before it left.
class CutFlattener::Rounds {
 public:
  explicit Rounds(const Listener& whole) : whole_(whole) {}

  void next() { ++round_; }
  Listener now() const { return whole_.part(doneBefore(round_), doneBefore(round_ + 1)); }

 private:
  static double doneBefore(int round) {
    constexpr double kLeft = 0.3;
    return 1 - std::pow(kLeft, round);
  }

  const Listener& whole_;
  int round_ = 0;
};

Status CutFlattener::takeCharts(FlatCut& cut) const {
  cut.charts = {chartsOf(with_.map.welded(), cut.open), {}};
  cut.charts.flat.resize(cut.charts.set.size());
  return constrain(cut);
}

Status CutFlattener::takeChartsAnew(FlatCut& cut, LaidCharts& before) const {
  before = std::move(cut.charts);
  Status s = takeCharts(cut);
  moveSame(before, cut.charts);
  return s;
}

Status CutFlattener::takeChartsAnew(FlatCut& cut) const {
  LaidCharts before;
  return takeChartsAnew(cut, before);
}

Status CutFlattener::constrain(FlatCut& cut) const {
  with_.listener.tell();
  if (with_.isSearch) {
    cut.constraints.assign(cut.charts.set.size(), {});
    return {};
  }
  const CutMesh mesh = meshOf(cut);
  Result<IdVector<ChartId, ChartConstraints>> constraints =
      chartConstraints(mesh, numberTexcoords(mesh), with_.fixed, with_.options);
  if (!constraints.ok()) return constraints.status();
  cut.constraints = std::move(constraints.value());
  return {};
}

Status CutFlattener::layOut(FlatCut& cut, const Listener& listener) const {
  if (!with_.isSearch)
    if (Status s =
            takeKnown(meshOf(cut), cut.constraints, with_.options, with_.pool, cut.charts.flat);
        !s.ok())
      return s;
  flattenAll(cut.constraints, with_.options, with_.pool, listener, cut.charts);
  return {};
}

Status CutFlattener::layOut(FlatCut& cut) const { return layOut(cut, with_.listener); }

Status CutFlattener::flatten(FlatCut& cut) const {
  constexpr int kMostRounds = 8;
  FlatCharts& flat = cut.charts.flat;
  if (Status s = layOutFixed(meshOf(cut), with_.fixed, with_.options, flat); !s.ok()) return s;
  if (Status s = checkUnpinned(cut.charts.set, cut.constraints, flat); !s.ok()) return s;
  if (giveUp(cut)) return {};
  Rounds rounds(with_.listener);
  if (Status s = layOut(cut, rounds.now()); !s.ok()) return s;
  if (Status s = cutWhileStretched(cut, kMostRounds, rounds); !s.ok() || cut.isGivenUp) return s;
  if (Status s = endSearch(cut, rounds.now()); !s.ok()) return s;
  return halveRuined(cut, rounds);
}

Status CutFlattener::layOutPieces(FlatCut& cut) const {
  constexpr int kMostRounds = 3;
  Rounds rounds(with_.listener);
  if (Status s = layOut(cut, rounds.now()); !s.ok()) return s;
  expectScale(cut.charts.set, stretchedPieces(cut.charts.set, cut.charts.flat, with_.options),
              with_.pool, cut.open);
  if (Status s = cutWhileStretched(cut, kMostRounds, rounds); !s.ok()) return s;
  return endSearch(cut, rounds.now());
}

/// Repeats as long as it helps.
Status CutFlattener::cutWhileStretched(FlatCut& cut, int mostRounds, Rounds& rounds) const {
  for (int k = 0; k < mostRounds && !with_.listener.isStopped(); ++k) {
    rounds.next();
    with_.times.book(with_.stage);
    const bool isCut = cutFurther(cut, rounds.now());
    with_.times.book(&UnwrapStages::seams);
    if (!isCut || with_.listener.isStopped() || giveUp(cut)) break;
    if (Status s = takeChartsAnew(cut); !s.ok()) return s;
    dropGivenUp(cut.charts.flat);
    if (Status s = layOut(cut, rounds.now()); !s.ok()) return s;
  }
  return {};
}

bool CutFlattener::giveUp(FlatCut& cut) const {
  cut.isGivenUp = with_.rival && isHopeless(with_.options, *with_.rival, cut);
  return cut.isGivenUp;
}

bool CutFlattener::cutFurther(FlatCut& cut, const Listener& listener) const {
  if (!canCut(with_.options)) return false;
  FlatCharts& flat = cut.charts.flat;
  IdVector<ChartId, Stretched> charts;
  for (const ChartId i : flat.ids()) {
    const FlatChart& chart = flat[i];
    const double leeway = cut.charts.set.leewayOf(i);
    const bool isAsked =
        (chart.isGivenUp() || isStretched(chart, leeway, with_.options)) && !chart.isCutEnough;
    charts.push_back(
        {isAsked ? stretchOf(chart.distortion, leeway, with_.options) : 0, chart.isGivenUp()});
  }
  const Further done =
      cutStretched(cut.charts.set, charts, with_.options, with_.pool, listener, cut.open);
  // Charts whose layout is kept have been tried.
  for (const ChartId i : charts.ids())
    flat[i].isCutEnough |= done != Further::Replaced && charts[i].stretch > 0;
  return done != Further::Nothing;
}

/// Tries more on charts for which no seam was found.
Status CutFlattener::endSearch(FlatCut& cut, const Listener& listener) const {
  for (FlatChart& chart : cut.charts.flat) chart.isCutEnough = true;
  return dropGivenUp(cut.charts.flat) ? layOut(cut, listener) : Status();
}

/// Splits charts in two that are still far from what is asked for. A chart that cannot be split
/// gets the layout that is always valid.
Status CutFlattener::halveRuined(FlatCut& cut, Rounds& rounds) const {
  constexpr int kMostHalvings = 24, kMostRounds = 4;
  for (int k = 0; canCut(with_.options) && k < kMostHalvings && !with_.listener.isStopped(); ++k) {
    const Result<bool> isAny =
        halve(cut, ruinedCharts(cut.charts.set, cut.charts.flat, with_.options.maxStretch));
    if (!isAny.ok()) return isAny.status();
    if (!isAny.value()) break;
    if (Status s = layOut(cut, rounds.now()); !s.ok()) return s;
    expectScale(cut.charts.set, stretchedPieces(cut.charts.set, cut.charts.flat, with_.options),
                with_.pool, cut.open);
    if (Status s = cutWhileStretched(cut, kMostRounds, rounds); !s.ok()) return s;
    if (Status s = endSearch(cut, rounds.now()); !s.ok()) return s;
  }
  return dropGivenUp(cut.charts.flat) ? layOut(cut, rounds.now()) : Status();
}

/// Splits the charts in two, and marks those that cannot be split. False if none can be.
Result<bool> CutFlattener::halve(FlatCut& cut,
                                 const IdVector<ChartId, std::uint8_t>& isAsked) const {
  IdVector<ChartId, std::uint8_t> isWhole;
  const bool isAny = abflat::halve(cut.charts.set, isAsked, with_.options, cut.open, isWhole);
  for (const ChartId i : isWhole.ids()) cut.charts.flat[i].isWhole |= isWhole[i] != 0;
  if (isAny)
    if (Status s = takeChartsAnew(cut); !s.ok()) return s;
  return isAny;
}

Result<bool> CutFlattener::halveInvalid(FlatCut& cut) const {
  Result<bool> isAny = halve(cut, ruinedCharts(cut.charts.set, cut.charts.flat, HUGE_VAL));
  if (!isAny.ok() || !isAny.value()) return isAny;
  if (Status s = layOut(cut); !s.ok()) return s;
  if (Status s = endSearch(cut, with_.listener); !s.ok()) return s;
  return isAny;
}

Status CutFlattener::takeBack(LaidCharts& before, const IdVector<ChartId, std::uint8_t>& isAsked,
                              const Seams& seams, FlatCut& cut) const {
  if (std::find(isAsked.begin(), isAsked.end(), 1) == isAsked.end()) return {};
  abflat::takeBack(before.set, isAsked, seams, cut.open);
  Status s = takeChartsAnew(cut);
  moveSame(before, cut.charts);
  return s;
}

}  // namespace abflat
