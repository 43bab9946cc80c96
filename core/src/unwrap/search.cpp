#include "unwrap/search.h"

#include <algorithm>
#include <utility>

#include "unwrap/cut_open.h"
#include "unwrap/flat_faces.h"
#include "unwrap/known.h"
#include "unwrap/layouts.h"
#include "unwrap/pieces.h"
#include "unwrap/small_charts.h"
#include "unwrap/variants.h"

namespace abflat {
namespace {

/// So many in a row end the search.
constexpr int kMostFruitless = 3;
/// How likely a search for the front is made after one that found seams there.
constexpr double kStillCut = 0.75;

/// Whether it only differs in costs.
bool isVaried(const SeamVariant& variant) {
  return variant.bound == SeamBound::Asked && !isForFront(variant);
}

/// Whether it says how likely another is to find better seams.
bool isCounted(const SeamVariant& variant) {
  return variant.bound != SeamBound::Exact && !isForFront(variant);
}

/// How many searches are expected, each of which may be the last.
class Expected {
 public:
  /// `front`: how likely one for the front is made.
  Expected(const std::vector<SeamVariant>& variants, double front)
      : variants_(variants), front_(front) {}

  /// From one of them on. `fruitless`: so far.
  double from(std::size_t k, int fruitless) const {
    if (k == variants_.size()) return 0;
    if (isForFront(variants_[k])) return front_ + after(k, fruitless);
    const bool isFruitless = fruitless >= kMostFruitless;
    // Made where everything unrolls, so that none with other costs is; else rarely.
    if (variants_[k].bound == SeamBound::Exact) return (isFruitless ? 1 : 0) + after(k, fruitless);
    const bool isLeftOut = isFruitless && isVaried(variants_[k]);
    return isLeftOut ? from(k + 1, fruitless) : 1 + after(k, fruitless);
  }

  /// After one of them.
  double after(std::size_t k, int fruitless) const {
    if (!isCounted(variants_[k])) return from(k + 1, fruitless);
    // How often one finds better seams, by measurement.
    const double better = isVaried(variants_[k]) ? 0.25 : 0.05;
    return better * from(k + 1, 0) + (1 - better) * from(k + 1, fruitless + 1);
  }

 private:
  const std::vector<SeamVariant>& variants_;
  double front_;
};

Status cutAgain(const SearchInput& input, const SeamVariant& variant, const CutFlattener& flattener,
                const Listener& ofSeams, FlatCut& cut) {
  const FlattenSettings& with = flattener.settings();
  SeamSummary summary;  // that of the first search holds
  with.times.book(&UnwrapStages::solve);
  cut.open = cutOpen(input.uncut, input.asked, variant, with.options, with.pool, ofSeams, summary);
  with.times.book(&UnwrapStages::seams);
  if (with.listener.isStopped()) return {};
  if (Status s = flattener.takeCharts(cut); !s.ok()) return s;
  return flattener.flatten(cut);
}

/// Cuts the surface in other ways, too, and keeps what turns out best.
Status tryOthers(const SearchInput& input, const std::vector<SeamVariant>& variants,
                 FlattenSettings with, Passes passes, FlatCut& best) {
  int fruitless = isSettled(with.options, best) ? kMostFruitless : 0;
  for (std::size_t k = 0; k < variants.size(); ++k) {
    SeamVariant variant = variants[k];
    if (fruitless >= kMostFruitless && isVaried(variant)) continue;
    if (isForFront(variant) && !isCutInFront(best.open)) continue;
    if (variant.bound == SeamBound::Exact && !isExactWorth(with.options, best)) continue;
    passes.next(Expected(variants, kStillCut).after(k, fruitless));
    with.listener = passes.layouts().at(Stage::Solve);
    FlatCut other;
    variant.before = &best.open;
    if (Status s =
            cutAgain(input, variant, CutFlattener(with), passes.seams().at(Stage::Solve), other);
        !s.ok())
      return s;
    if (with.listener.isStopped()) break;
    const bool isBetter =
        !other.isGivenUp && takeBetter(input.uncut.welded, with.options, best, other);
    if (isCounted(variant)) fruitless = isBetter ? 0 : fruitless + 1;
  }
  return {};
}

/// Lays out what has other seams now. The charts before that `refused` names, of these and the
/// present ones, get `seams` back, which they had.
template <class Refused>
Status layOutChanged(const CutFlattener& flattener, const Seams& seams, const Refused& refused,
                     FlatCut& cut) {
  LaidCharts before;
  if (Status s = flattener.takeChartsAnew(cut, before); !s.ok()) return s;
  if (Status s = flattener.layOut(cut); !s.ok()) return s;
  if (flattener.settings().listener.isStopped()) return {};
  return flattener.takeBack(before, refused(before, cut.charts), seams, cut);
}

/// Joins charts that are too small to be worth a seam, where the bounds allow it.
Status joinSmall(const CutFlattener& flattener, FlatCut& cut) {
  constexpr int kMostRounds = 6;
  const FlattenSettings& with = flattener.settings();
  SmallCharts small;
  const auto refused = [&](const LaidCharts& before, const LaidCharts& now) {
    return small.refused(before, now, with.options, cut.open.mirror);
  };
  for (int k = 0; k < kMostRounds && canCut(with.options) && !with.listener.isStopped(); ++k) {
    const Seams seams = small.join(cut.charts, with.options, cut.open);
    if (seams.empty()) break;
    if (Status s = layOutChanged(flattener, seams, refused, cut); !s.ok()) return s;
  }
  return {};
}

/// Flat faces that their charts bend get charts of their own, unless only the length of seams
/// counts.
Status freeFlatFaces(const CutFlattener& flattener, FlatCut& cut) {
  const FlattenSettings& with = flattener.settings();
  if (!canCut(with.options) || with.options.seamCosts == SeamCosts::Length ||
      with.listener.isStopped())
    return {};
  const Seams seams = cutOutFlatFaces(cut.charts, with.options, cut.open);
  if (seams.empty()) return {};
  const auto refused = [&](const LaidCharts& before, const LaidCharts& now) {
    return worseCutOut(before, now, with.options);
  };
  return layOutChanged(flattener, seams, refused, cut);
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

double expectedSearches(std::size_t triangles) {
  constexpr double kHasFront = 0.1;
  return Expected(variantsWorth(triangles, 1), kHasFront).from(0, 0);
}

double expectedSearches(const std::vector<SeamVariant>& variants, const OpenSurface& open) {
  return Expected(variants, isCutInFront(open) ? kStillCut : 0).from(0, 0);
}

Status searchMore(const SearchInput& input, const std::vector<SeamVariant>& variants,
                  const FlattenSettings& settings, Passes passes, FlatCut& cut) {
  FlattenSettings searching = settings;
  searching.isSearch = true;
  searching.rival = &cut;
  if (Status s = tryOthers(input, variants, searching, std::move(passes), cut); !s.ok()) return s;
  if (Status s = joinSmall(CutFlattener(searching), cut); !s.ok()) return s;
  if (Status s = freeFlatFaces(CutFlattener(searching), cut); !s.ok()) return s;
  return settings.listener.isStopped() ? Status() : layOutAsAsked(CutFlattener(settings), cut);
}

}  // namespace abflat
