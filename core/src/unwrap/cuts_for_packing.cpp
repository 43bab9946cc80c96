#include "unwrap/cuts_for_packing.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <utility>

#include "base/long_sum.h"
#include "base/point2.h"
#include "base/portable_math.h"
#include "hole/fill_holes.h"
#include "pack/pack.h"
#include "seam/piece_fitting.h"
#include "unwrap/part_of_charts.h"

namespace abflat {
namespace {

/// What cuts should achieve: the largest logarithm of the texel density, less a share of the length
/// of the cuts.
struct PackingGoal {
  double seamWorth = 0;    ///< cost, in that logarithm, of seams as long as the root of the area
  double utilization = 0;  ///< more than this counts no more
  double mostCost = HUGE_VAL;  ///< of a cut, for its length
};

/// What packing hardly ever exceeds.
constexpr double kMostUtilization = 0.92;

PackingGoal goalOf(const UnwrapOptionValues& options) {
  constexpr double kSeamWorth = 0.04;
  // What lies well is not cut where that would be in plain sight.
  constexpr double kAlongFeatures = 0.5;
  if (options.minUtilization == kAutoMinUtilization)
    return {kSeamWorth, kMostUtilization, kAlongFeatures};
  // A fit on few cells predicts a little more or less than packing achieves.
  constexpr double kBarely = 0.005, kMore = 1.02, kMostAsked = 0.96;
  return {kBarely, std::min(kMore * options.minUtilization, kMostAsked), HUGE_VAL};
}

/// Of more charts than that, only long ones are cut.
constexpr std::size_t kMostToCut = 64;

/// The charts that may be cut: where there are too many for that, those that are not specks, which
/// find a place between the others. `cuts`: how many of the charts come from cuts.
IdVector<ChartId, std::uint8_t> largeCharts(const FlatCharts& flat, std::size_t cuts) {
  constexpr double kLeastShare = 1e-3;
  if (flat.size() <= kMostToCut + cuts) return IdVector<ChartId, std::uint8_t>(flat.size(), 1);
  LongSum area;
  for (const FlatChart& chart : flat) area.add(chart.area);
  IdVector<ChartId, std::uint8_t> out;
  for (const FlatChart& chart : flat) out.push_back(chart.area >= kLeastShare * area.value());
  return out;
}

std::size_t countOf(const IdVector<ChartId, std::uint8_t>& isLarge) {
  return static_cast<std::size_t>(std::count(isLarge.begin(), isLarge.end(), 1));
}

/// `part`: the surface in the order in which cuts are sought.
FlatSurface flatSurface(const PackedCharts& packed, const OpenSurface& open, const SeamPart& part) {
  const LaidCharts& charts = packed.charts;
  FlatSurface out;
  Seams seams = part.ofCorners(open.seams);
  for (const SurfaceCorner h : seams.ids()) seams[h] = seams[h] && part.mesh.twin[h].exists();
  out.surface = cutAlong(part.mesh, seams);
  const IdVector<SurfaceCorner, SurfaceCorner> inPart = part.cornersInPart(open.mesh.twin.size());
  out.at.resize(out.surface.vertexCount());
  out.canCut.assign(out.surface.charts.size(), 0);
  out.density.assign(out.surface.charts.size(), 1);
  double area = 0;
  for (const ChartId i : charts.set.ids()) {
    const ChartTopology chart = charts.set.topology(i);
    const FlatChart& flat = charts.flat[i];
    const SurfaceCorner first = inPart[cornerOf(chart.triangles.front(), 0)];
    if (!first.exists()) continue;
    const CutChartId cutChart = out.surface.chartOf(first);
    out.canCut[cutChart] = flat.problem.empty();
    out.density[cutChart] = packed.density(i);
    area += flat.area;
    for (const ChartCorner c : chart.surfaceCorners()) {
      const auto [x, y] = pointAt(flat.unpacked, chart.vertexOfCorner[c]);
      out.at[out.surface.tail(inPart[chart.onSurface(c)])] = {x, y};
    }
  }
  out.unitArea = area / part.mesh.totalArea();
  return out;
}

/// How many cuts may be tried. It grows with the triangles, as the rest of a run does.
struct Tries {
  int fruitless = 0;  ///< until one is worth its cost
  int fruitful = 0;   ///< after that
};

Tries triesFor(const OpenSurface& open) {
  constexpr int kFruitless = 60, kFruitful = 144, kTrianglesOfTry = 40;
  const int more = static_cast<int>(open.mesh.triangleCount() / kTrianglesOfTry);
  return {kFruitless + more / 5, kFruitful + more / 2};
}

/// Into how many parts each of the long charts is cut, so that `share` of the side of a square
/// holds the length of a part.
std::vector<int> partsFor(const std::vector<LongChart>& charts, double side, double share) {
  constexpr double kMost = 1000;
  std::vector<int> out;
  out.reserve(charts.size());
  for (const LongChart& chart : charts)
    out.push_back(
        static_cast<int>(std::clamp(std::ceil(chart.length / (share * side)), 1.0, kMost)));
  return out;
}

/// Searches for the best cuts.
class CutSearch {
 public:
  /// `wanted`: the gain in the logarithm of the density that counts.
  CutSearch(PieceFitting& uncut, const PackingGoal& goal, double wanted, Tries tries)
      : uncut_(uncut), goal_(goal), wanted_(wanted), side_(uncut.leastSide()), tries_(tries) {}

  /// Cuts all long charts at once, in equal parts: as long as one of them is too long for a smaller
  /// square, cutting another gains nothing. `most`: largest gain to try; parts for more than is
  /// wanted may be fewer.
  void cutLong(const std::vector<LongChart>& charts, double most, const Listener& listener) {
    constexpr double kStep = 0.05;
    constexpr int kMostSteps = 80, kMostCuts = 256;
    if (!(side_ > 0)) return;
    const int steps = std::clamp(static_cast<int>(most / kStep), 1, kMostSteps);
    for (const double share : {0.97, 0.485, 0.32, 0.24, 0.19}) {
      std::vector<int> before;
      // From the smallest square on: once cuts are found, it is soon clear whether others gain
      // less.
      for (int k = steps; k > 0 && listener.tell(); --k) {
        std::vector<int> parts = partsFor(charts, side_ * portable::exp(-most * k / steps), share);
        if (parts == before) continue;
        before = std::move(parts);
        const int cuts =
            std::accumulate(before.begin(), before.end(), 0) - static_cast<int>(before.size());
        if (cuts <= kMostCuts && wanted_ - goal_.seamWorth * PieceFitting::costOf(cuts, 0) > best_)
          attemptParts(charts, before);
      }
    }
  }

  /// Cuts where that lets the most area find a place, in ever smaller squares.
  void cutAny(const Listener& listener) {
    constexpr double kStep = 0.05;
    constexpr int kMostSteps = 16, kFailuresAtFirst = 3, kFailuresLater = 2;
    if (!(side_ > 0)) return;
    const int steps = std::clamp(static_cast<int>(wanted_ / kStep), 1, kMostSteps);
    int failures = 0;  // in a row
    for (int k = 1; k <= steps && listener.tell(); ++k) {
      const double gain = wanted_ * k / steps;
      if (gain <= reached_) continue;
      if ((found_ ? tries_.fruitful : tries_.fruitless) <= 0) break;
      const bool isMore = found_ && attempt(*found_, gain);
      const bool isAnew = attempt(uncut_, gain);
      failures = isMore || isAnew ? 0 : failures + 1;
      if (failures == (found_ ? kFailuresLater : kFailuresAtFirst)) break;
    }
  }

  /// The best cuts; null if none are worth their cost.
  std::unique_ptr<PieceFitting> take() { return std::move(found_); }

 private:
  void attemptParts(const std::vector<LongChart>& charts, const std::vector<int>& parts) {
    auto now = std::make_unique<PieceFitting>(uncut_);
    for (std::size_t i = 0; i < charts.size(); ++i)
      if (parts[i] > 1) now->cutAcross(charts[i], parts[i]);
    if (now->count() == 0) return;
    const double least = best_ + goal_.seamWorth * now->cost();
    if (now->fits(side_ * portable::exp(-least))) keep(std::move(now));
  }

  /// If the cuts are the best so far.
  void keep(std::unique_ptr<PieceFitting> now) {
    const double gained = std::min(portable::log(side_ / now->leastSide()), wanted_);
    const double worth = gained - goal_.seamWorth * now->cost();
    if (!(worth > best_)) return;
    best_ = worth;
    reached_ = gained;
    found_ = std::move(now);
  }

  /// Whether cuts can achieve that gain.
  bool attempt(const PieceFitting& from, double gain) {
    auto now = std::make_unique<PieceFitting>(from);
    const double affordable = (gain - best_) / goal_.seamWorth;
    int& tries = best_ > 0 ? tries_.fruitful : tries_.fruitless;
    if (!now->fitInto(side_ * portable::exp(-gain), affordable, tries)) return false;
    keep(std::move(now));
    return true;
  }

  const PieceFitting& uncut_;
  const PackingGoal goal_;
  const double wanted_, side_;
  Tries tries_;
  double best_ = 0, reached_ = 0;
  std::unique_ptr<PieceFitting> found_;
};

}  // namespace

CutMode cutModeOf(const UnwrapOptions& options, const FlatCharts& flat, std::size_t cuts) {
  constexpr std::size_t kMostToCutLong = 512;
  const auto isFixed = [](const FlatChart& c) { return c.isFixed; };
  if (options.packingCuts == PackingCuts::Never || options.minUtilization == 0 ||
      options.texelDensity != kAutoTexelDensity || !options.seams.isAuto || options.t != kAutoT ||
      std::any_of(flat.begin(), flat.end(), isFixed))
    return CutMode::None;
  const std::size_t large = countOf(largeCharts(flat, cuts)),
                    count = large > cuts ? large - cuts : 0;
  if (large == 0 || count > kMostToCutLong) return CutMode::None;
  const bool isAny = !options.straightSeams && count <= kMostToCut;
  return isAny ? CutMode::All : CutMode::Long;
}

CutsForPacking findCutsForPacking(const PackedCharts& packed, const OpenSurface& open,
                                  const UnwrapOptions& options, double utilization,
                                  const Listener& listener) {
  constexpr double kLeast = 0.02;
  constexpr int kCells = 96, kCellsForLong = 192;  // parts of long charts are narrow
  const PackingGoal goal = goalOf(options);
  CutsForPacking out;
  const CutMode mode = cutModeOf(options, packed.charts.flat, 0);
  if (mode == CutMode::None || !(utilization > 0)) return out;
  const auto gainTo = [&](double share) { return portable::log(share / utilization) / 2; };
  const double wanted = gainTo(goal.utilization);
  if (!(wanted > kLeast)) return out;
  const SeamPart part = partOfCharts(packed.charts, open, largeCharts(packed.charts.flat, 0));
  const FlatSurface surface = flatSurface(packed, open, part);
  const auto fittingOn = [&](int cells) {
    const QuickFit fit(packOptionsOf(options), cells);
    return std::make_unique<PieceFitting>(part.mesh, surface, fit, goal.mostCost);
  };
  auto uncut = fittingOn(kCells);
  std::vector<LongChart> longCharts = uncut->longCharts();
  // They lie along the longer side of a tile.
  for (LongChart& chart : longCharts)
    chart.length *= options.resolution.meanSide() / options.resolution.longer();
  if (!longCharts.empty()) uncut = fittingOn(kCellsForLong);
  for (const LongChart& chart : longCharts) uncut->cutAnywhere(chart);
  CutSearch search(*uncut, goal, wanted, triesFor(open));
  if (!longCharts.empty())
    search.cutLong(longCharts, std::max(wanted, gainTo(kMostUtilization)), listener);
  if (mode == CutMode::All) search.cutAny(listener);
  const std::unique_ptr<PieceFitting> found = search.take();
  if (!found) return out;
  for (const SurfaceCorner h : found->cuts()) out.halfEdges.push_back(part.wholeHalfEdge[h]);
  out.count = found->count();
  out.length = found->length();
  return out;
}

void addCuts(const CutsForPacking& cuts, const UnwrapOptionValues& options, OpenSurface& open) {
  open.seams.resize(open.mesh.twin.size(), 0);
  for (const SurfaceCorner h : cuts.halfEdges) open.seams[h] = open.seams[open.mesh.twin[h]] = 1;
  openTouchedHoles(open.mesh, cutAlong(open.mesh, open.seams), options.fillHoles, open.seams);
}

void takeBack(const ChartSet& before, const IdVector<ChartId, std::uint8_t>& isAsked,
              const Seams& seams, OpenSurface& open) {
  const CutSurface s = cutAlong(open.mesh, seams);
  IdVector<CutChartId, std::uint8_t> isBack(s.charts.size(), 0);
  for (const ChartId i : before.ids())
    isBack[s.chartOfTriangle[before.topology(i).triangles.front()]] = isAsked[i];
  for (const SurfaceCorner h : seams.ids())
    if (isBack[s.chartOf(h)]) open.seams[h] = seams[h];
}

bool isWorth(const AtlasReport& atlas, double seamCost, const UnwrapOptionValues& options) {
  const double ratio = atlas.texelDensity / atlas.uncutTexelDensity;
  return ratio > 1 && portable::log(ratio) >
                          goalOf(options).seamWorth *
                              PieceFitting::costOf(atlas.packingCuts,
                                                   std::min(seamCost, atlas.packingCutLength));
}

}  // namespace abflat
