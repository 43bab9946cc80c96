#include "unwrap/pack_cut.h"

#include <cmath>
#include <string>
#include <utility>

#include "unwrap/atlas.h"
#include "unwrap/cuts_for_packing.h"
#include "unwrap/densities.h"
#include "unwrap/layouts.h"
#include "unwrap/measure_seams.h"
#include "unwrap/packed_charts.h"
#include "unwrap/pieces.h"
#include "unwrap/pinned.h"
#include "unwrap/rounding.h"
#include "unwrap/spacing.h"
#include "unwrap/utilization_note.h"

namespace abflat {
namespace {

constexpr double kUncut = 0.6;  ///< share of packing before charts may be cut for it

/// What a cut of packed charts changes, as it was before.
struct PackedState {
  LaidCharts charts;
  Seams seams;
  Packing packing;
  AtlasReport atlas;
};

class CutPacker {
 public:
  CutPacker(const CutFlattener& flattener, const PackSettings& settings, Stacks& stacks,
            Surface& surface, FixedTriangles& fixed, FlatCut& cut, UnwrapReport& report)
      : flattener_(flattener),
        settings_(settings),
        with_(flattener.settings()),
        stacks_(stacks),
        parts_{surface, fixed, cut.open, cut.charts},
        cut_(cut),
        report_(report) {}

  Status pack() {
    if (Status s = checkPinned(mesh(), with_.options, cut_.charts.flat); !s.ok()) return s;
    if (stacks_.leaveOutCharts(cut_.constraints, parts_))
      if (Status s = flattener_.constrain(cut_); !s.ok()) return s;
    const bool mayCut = cutModeOf(with_.options, cut_.charts.flat, 0) != CutMode::None;
    Status s = packNow(0, mayCut ? kUncut : 1);
    if (s.ok() && mayCut) s = cutForPacking();
    if (s.ok()) s = keepPartsApart();
    if (s.ok() && !settings_.listener.isStopped()) s = fitToFile();
    if (s.ok()) note();
    return s;
  }

 private:
  CutMesh mesh() const { return {with_.map, cut_.charts.set}; }

  PackedCharts packed() {
    return {settings_.unit,
            with_.map.welded().mesh.positions,
            settings_.upAxis,
            with_.pool,
            cut_.charts,
            packing_,
            densitiesOf(mesh(), with_.options.faceDensities, settings_.truePositions)};
  }

  /// Packs, which takes the given range of the stage's progress.
  Status packNow(double from, double to, double formerDensity = 0) {
    return packAll(packed(), with_.options, settings_.listener.part(from, to), report_.atlas,
                   formerDensity);
  }

  /// Cuts charts if that makes the packing so much denser that it is worth the seams; otherwise
  /// leaves them as they were.
  Status cutForPacking() {
    const CutsForPacking cuts =
        findCutsForPacking(packed(), cut_.open, with_.options, report_.atlas.utilization,
                           settings_.listener.part(kUncut, kUncut));
    if (cuts.halfEdges.empty() || settings_.listener.isStopped()) return {};
    Seams seams = seamsNow();
    const double length = seamLength(cut_.open), cost = seamCost(cut_.open);
    addCuts(cuts, with_.options, cut_.open);
    PackedState before = takeState(std::move(seams));
    if (Status s = flattener_.takeChartsAnew(cut_, before.charts); !s.ok()) return s;
    // Where they lie, their new ends need not be straight.
    if (!with_.options.straightSeams)
      takePieces(before.charts, with_.options, with_.pool, cut_.charts);
    if (Status s = flattener_.layOutPieces(cut_); !s.ok() || settings_.listener.isStopped())
      return s;
    if (Status s = joinStretched(before); !s.ok()) return s;
    report_.atlas.packingCuts = static_cast<int>(cut_.charts.set.size() - before.charts.set.size());
    report_.atlas.packingCutLength = seamLength(cut_.open) - length;
    report_.atlas.uncutTexelDensity = before.atlas.texelDensity;
    Status packed = packNow(kUncut, 1);
    if (packed.code == StatusCode::Aborted) return packed;
    if (packed.ok() && isWorth(report_.atlas, seamCost(cut_.open) - cost, with_.options))
      return stackPieces();
    return restore(before);
  }

  /// Joins charts again that were cut for packing into pieces with too much stretch.
  Status joinStretched(PackedState& before) {
    return flattener_.takeBack(before.charts,
                               stretchedByCuts(before.charts, cut_.charts, with_.options),
                               before.seams, cut_);
  }

  /// Packs again if some of the pieces are alike.
  Status stackPieces() {
    if (!stacks_.leaveOutCharts(cut_.constraints, parts_)) return {};
    Status s = flattener_.constrain(cut_);
    return s.ok() ? packNow(1, 1) : s;
  }

  /// Cuts charts whose parts are too near each other, and packs again, unless that does not fit.
  Status keepPartsApart() {
    constexpr int kMostRounds = 4;
    constexpr std::size_t kMany = 1000;
    for (int k = 0; k < kMostRounds && canCut(with_.options) && !settings_.listener.isStopped();
         ++k) {
      Seams seams = seamsNow();
      if (!cutBetween(cut_.charts, nearParts(), with_.options, cut_.open)) break;
      PackedState before = takeState(std::move(seams));
      if (Status s = flattener_.takeChartsAnew(cut_, before.charts); !s.ok()) return s;
      takePieces(before.charts, with_.options, with_.pool, cut_.charts);
      if (Status s = flattener_.layOutPieces(cut_); !s.ok() || settings_.listener.isStopped())
        return s;
      // Among many charts, the pieces of a few make little difference.
      const bool isAlike = before.charts.set.size() > kMany;
      Status packed = packNow(1, 1, isAlike ? before.packing.texelDensity : 0);
      if (packed.code == StatusCode::AtlasTooSmall) return restore(before);
      if (!packed.ok()) return packed;
    }
    return {};
  }

  /// What lies nearer to another part of its chart than the padding.
  IdVector<ChartId, NearParts> nearParts() { return nearPartsOf(packed(), with_.options); }

  /// Rounds the atlas as its file does. Charts that this makes invalid are split in two, and all
  /// are packed again.
  Status fitToFile() {
    constexpr int kMostSplits = 6;
    for (int k = 0; !settings_.listener.isStopped(); ++k) {
      std::vector<std::string> notes = checkAll(packed(), with_.options, report_.atlas);
      Result<bool> isSplit = false;
      if (k < kMostSplits && canCut(with_.options)) isSplit = flattener_.halveInvalid(cut_);
      if (!isSplit.ok()) return isSplit.status();
      if (!isSplit.value()) {
        for (std::string& note : notes) report_.notes.push_back(std::move(note));
        return {};
      }
      if (Status s = packNow(1, 1); !s.ok()) return s;
    }
    return {};
  }

  void note() {
    for (std::string text : {utilizationNote(packed(), with_.map, with_.options, report_.atlas),
                             spacingNote(mesh(), cut_.charts.flat, nearParts(), with_.options)})
      if (!text.empty()) report_.notes.push_back(std::move(text));
  }

  Seams seamsNow() const {
    Seams out = cut_.open.seams;
    out.resize(cut_.open.mesh.twin.size(), 0);
    return out;
  }

  /// `seams`: those of the charts that are packed. Charts follow when they are taken anew.
  PackedState takeState(Seams seams) {
    PackedState out;
    out.seams = std::move(seams);
    out.packing = std::move(packing_);
    out.atlas = report_.atlas;
    return out;
  }

  Status restore(PackedState& before) {
    moveSame(cut_.charts, before.charts);
    cut_.charts = std::move(before.charts);
    cut_.open.seams = std::move(before.seams);
    packing_ = std::move(before.packing);
    report_.atlas = before.atlas;
    placeInAtlas(packing_, cut_.charts.flat);
    return flattener_.constrain(cut_);
  }

  const CutFlattener& flattener_;
  const PackSettings& settings_;
  const FlattenSettings& with_;
  Stacks& stacks_;
  const CutParts parts_;
  FlatCut& cut_;
  UnwrapReport& report_;
  Packing packing_;
};

}  // namespace

Status packCut(const CutFlattener& flattener, const PackSettings& settings, Stacks& stacks,
               Surface& surface, FixedTriangles& fixed, FlatCut& cut, UnwrapReport& report) {
  return CutPacker(flattener, settings, stacks, surface, fixed, cut, report).pack();
}

}  // namespace abflat
