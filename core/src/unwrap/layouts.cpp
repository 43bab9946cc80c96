#include "unwrap/layouts.h"

#include <algorithm>
#include <atomic>

#include "base/counted.h"
#include "base/number_text.h"
#include "base/stable_order.h"
#include "unwrap/reordered.h"
#include "unwrap/stretch.h"

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

/// Whether some vertices are asked to lie in certain places or on lines.
bool namesVertices(const ChartConstraints& constraints) {
  return !constraints.pins.empty() || !constraints.straight.empty();
}

/// Flattens a chart in an order of its own, so that its layout does not depend on the mesh's. It is
/// measured in the mesh's order, as layouts that are taken over are.
FlatChart flattenInOrder(const ChartSet& set, ChartId i, const UnwrapOptionValues& options,
                         Patience patience, ThreadPool& pool, const Listener& listener) {
  IdVector<ChartVertex, ChartVertex> former;
  FlatChart out = flattenOne(set.chartInOrder(i, former), options, {}, patience, pool, listener);
  if (out.unpacked.empty()) return out;
  const DiskChart chart = set.chart(i);
  out.unpacked = inFormerOrder(out.unpacked, former);
  out.area = areaOf(chart);
  out.distortion = ChartDistortion(measureDistortion(chart, inChartUnit(chart, out.unpacked)));
  return out;
}

/// How many charts there are of a kind, and the worst of them.
struct Worst {
  std::size_t count = 0;
  ChartId chart;
  double value = 0;

  void add(ChartId i, double x) {
    if (count++ > 0 && x <= value) return;
    chart = i;
    value = x;
  }
};

}  // namespace

bool canCut(const UnwrapOptions& options) { return options.seams.isAuto && isFree(options); }

void flattenAll(const IdVector<ChartId, ChartConstraints>& constraints,
                const UnwrapOptions& options, ThreadPool& pool, const Listener& listener,
                LaidCharts& charts) {
  constexpr double kUsualSteps = 8;  // of a chart's solver and refining, half of them
  const ChartSet& set = charts.set;
  FlatCharts& flat = charts.flat;
  const std::vector<std::uint32_t> order = largestFirst(set);
  std::size_t triangles = 0;
  // Seams are only found for charts without pins.
  const auto patienceFor = [&](ChartId i) {
    if (!canCut(options) || !constraints[i].pins.empty() || flat[i].isWhole) return Patience::All;
    return flat[i].isCutEnough ? Patience::Much : Patience::Little;
  };
  const auto isKnown = [&](ChartId i) {
    return !flat[i].unpacked.empty() && (constraints[i].pins.empty() || flat[i].isFixed);
  };
  for (const ChartId i : set.ids())
    if (!isKnown(i)) triangles += set.topology(i).triangleCount();
  std::atomic<std::size_t> done{0};
  parallelFor(&pool, set.size(), [&](std::size_t k) {
    if (listener.isStopped()) return;
    const ChartId i(order[k]);
    FlatChart& out = flat[i];
    if (isKnown(i)) return;
    const std::size_t size = set.topology(i).triangleCount();
    const auto share = [&](std::size_t count) {
      return static_cast<double>(count) / static_cast<double>(triangles);
    };
    const std::size_t before = done;
    const Listener ofChart =
        listener.part(share(before), share(before + size)).approach(kUsualSteps);
    const bool isCutEnough = out.isCutEnough, isWhole = out.isWhole;
    out = namesVertices(constraints[i])
              ? flattenOne(set.chart(i), options, constraints[i], patienceFor(i), pool, ofChart)
              : flattenInOrder(set, i, options, patienceFor(i), pool, ofChart);
    out.isCutEnough = isCutEnough;
    out.isWhole = isWhole;
    done += size;
  });
}

IdVector<ChartId, std::uint8_t> stretchedPieces(const ChartSet& set, const FlatCharts& flat,
                                                const UnwrapOptionValues& options) {
  IdVector<ChartId, std::uint8_t> out;
  out.reserve(flat.size());
  for (const ChartId i : flat.ids())
    out.push_back(!flat[i].isCutEnough && isStretched(flat[i], set.leewayOf(i), options));
  return out;
}

IdVector<ChartId, std::uint8_t> ruinedCharts(const ChartSet& set, const FlatCharts& flat,
                                             double most) {
  constexpr double kRuined = 10;
  IdVector<ChartId, std::uint8_t> out;
  out.reserve(flat.size());
  for (const ChartId i : flat.ids()) {
    const FlatChart& chart = flat[i];
    const bool isRuined =
        !chart.problem.empty() || chart.isDrawnOut ||
        chart.distortion.symmetricDirichlet > 1 + kRuined * set.leewayOf(i) * (most - 1);
    out.push_back(!chart.isFixed && !chart.isWhole && isRuined);
  }
  return out;
}

bool dropGivenUp(FlatCharts& flat) {
  bool isAny = false;
  for (FlatChart& chart : flat) {
    const bool isMoreTried = chart.isWhole || chart.patience == Patience::Little;
    if (!chart.isGivenUp() || !chart.isCutEnough || !isMoreTried) continue;
    const bool isWhole = chart.isWhole;
    chart = {};
    chart.isCutEnough = isAny = true;
    chart.isWhole = isWhole;
  }
  return isAny;
}

void noteStretched(const CutMesh& mesh, const FlatCharts& flat, const UnwrapOptions& options,
                   std::vector<std::string>& notes) {
  if (!options.seams.isAuto) return;
  const char* const why = isFree(options)         ? ": no seam that was tried helps enough"
                          : options.straightSeams ? ": straight seams force that"
                                                  : ": a larger t, or auto, stretches less";
  const auto note = [&](double ChartDistortion::*measure, double least, double most,
                        const char* isBeyond) {
    const auto of = [&](ChartId i) { return flat[i].distortion.*measure; };
    Worst inFront, others;
    for (const ChartId i : flat.ids()) {
      if (flat[i].isFixed || of(i) <= most) continue;
      const bool isAllowed = of(i) <= least + mesh.set.leewayOf(i) * (most - least);
      (isAllowed ? inFront : others).add(i, of(i));
    }
    const auto add = [&](const Worst& worst, const char* is, const char* are, const char* reason) {
      if (worst.count == 0) return;
      const std::uint32_t face{mesh.map.face(mesh.set.topology(worst.chart).triangles.front())};
      notes.push_back(counted(worst.count, is, are) + isBeyond + withDigits(most, 6) + ", up to " +
                      withDigits(worst.value, 5) + " for the chart of face " +
                      std::to_string(face) + reason);
    };
    add(others, "chart is ", "charts are ", why);
    add(inFront, "chart in the front of a figure is ", "charts in the front of a figure are ",
        ", so that no seam crosses it");
  };
  note(&ChartDistortion::symmetricDirichlet, 1, options.maxStretch, "stretched by more than ");
  note(&ChartDistortion::sheared, 0, mostSheared(options), "sheared over a share of more than ");
}

}  // namespace abflat
