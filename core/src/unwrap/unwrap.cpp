#include "abflat/unwrap.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "abflat/mesh.h"
#include "abflat/peak_memory.h"
#include "base/free_memory.h"
#include "base/guarded.h"
#include "base/parallel.h"
#include "base/stopwatch.h"
#include "chart/chart_set.h"
#include "cut/front.h"
#include "mesh/notches.h"
#include "mesh/surface_map.h"
#include "mesh/triangle_geometry.h"
#include "seam/given_seams.h"
#include "seam/hard_edges.h"
#include "seam/scale_seams.h"
#include "seam/vary_costs.h"
#include "unwrap/atlas.h"
#include "unwrap/certificate.h"
#include "unwrap/chart.h"
#include "unwrap/chart_shapes.h"
#include "unwrap/cuts_for_packing.h"
#include "unwrap/densities.h"
#include "unwrap/fixed.h"
#include "unwrap/known.h"
#include "unwrap/layouts.h"
#include "unwrap/monitor.h"
#include "unwrap/output.h"
#include "unwrap/pieces.h"
#include "unwrap/pinned.h"
#include "unwrap/rectify.h"
#include "unwrap/seams.h"
#include "unwrap/small_charts.h"
#include "unwrap/spacing.h"
#include "unwrap/stacks.h"
#include "unwrap/stretch.h"
#include "unwrap/turned.h"
#include "unwrap/unseen.h"
#include "unwrap/utilization_note.h"
#include "unwrap/variants.h"

namespace abflat {
namespace {

/// Exponent of the power of two that scales the largest coordinate of a face into 1 to 2.
int exponentOf(const PolygonMesh& mesh) {
  double largest = 0;
  for (const std::size_t v : mesh.faceVertices)
    for (std::size_t d = 0; d < 3; ++d)
      largest = std::max(largest, std::abs(mesh.positions[3 * v + d]));
  return largest > 0 ? std::ilogb(largest) : 0;
}

/// How often the search for seams reports until about half of it is done; by measurement.
double usualBeats(std::size_t triangles) { return 40 + 3e-4 * static_cast<double>(triangles); }

/// One run, stage by stage.
class Unwrapping {
 public:
  /// The mesh and lengths in the options are scaled to units of 2^exponent.
  Unwrapping(const PolygonMesh& input, const UnwrapOptions& options, int exponent,
             UnfitFaces& unfit)
      : input_(input),
        options_(options),
        stacks_(input, welded_, options, unfit),
        unit_(std::ldexp(1.0, exponent)),
        monitor_(options.progress) {}

  Result<UnwrapResult> run() {
    if (Status s = checkInput(); !s.ok()) return s;
    report_.options = options_;
    const std::pair<const StageSpan&, Status (Unwrapping::*)()> stages[] = {
        {kSurface, &Unwrapping::readSurface}, {kSeams, &Unwrapping::cut},
        {kSolve, &Unwrapping::flatten},       {kPack, &Unwrapping::packCharts},
        {kCheck, &Unwrapping::finish},
    };
    for (const auto& [stage, work] : stages) {
      if (monitor_.tell(stage))
        if (Status s = (this->*work)(); !s.ok()) return s;
      if (monitor_.stopped()) return Status{StatusCode::Aborted, "cancelled"};
      report_.timings.*stage.field += watch_.lap();
      report_.peakMemory.*stage.field = peakMemory();
      giveBackFreeMemory();
    }
    return std::move(out_);
  }

 private:
  SurfaceMap map() const { return {input_, welded_, surface_}; }
  CutMesh cutMesh() const { return {map(), charts_.set}; }
  std::size_t upAxis() const {
    return options_.up == Up::Z || (options_.up == Up::Auto && input_.isZUp) ? 2 : 1;
  }
  PackedCharts packedCharts() {
    return {unit_,
            welded_.mesh.positions,
            upAxis(),
            *pool_,
            charts_,
            packing_,
            densitiesOf(cutMesh(), options_.faceDensities, truePositions_)};
  }

  Status checkInput() const {
    if (options_.udim && options_.texelDensity == kAutoTexelDensity)
      return {StatusCode::InvalidOption, "udim needs a numeric texel density"};
    if (options_.packingCuts == PackingCuts::Never && options_.minUtilization > 0)
      return {StatusCode::InvalidOption,
              "with packingCuts = never all charts stay whole, so minUtilization has no effect; "
              "leave one of them out"};
    if (input_.faceCount() == 0) return {StatusCode::EmptyMesh, "the mesh has no faces"};
    return checkDensities(options_.faceDensities, input_.faceCount());
  }

  Status readSurface() {
    const Pulse pulse([this] { return monitor_.tell(kSurface); });
    PolygonMesh inUnits = input_;
    for (double& x : inUnits.positions) x /= unit_;
    report_.input = inspect(inUnits, pulse);
    // A disk may be one because it has been cut, so it is not welded, except at poles that are open
    // because each face has its own vertex there.
    const bool isDisk = report_.input.disk.ok();
    weldAndBuild(inUnits, !isDisk, {}, pulse);
    if (isDisk && !pulse.isStopped())
      if (const VertexPairs notches = findNotches(welded_.mesh, surface_); !notches.empty())
        weldAndBuild(inUnits, false, notches, pulse);
    if (pulse.isStopped()) return {};
    if (surface_.table.vertex.empty())
      return {StatusCode::EmptyMesh, "every face has fewer than three distinct corners"};
    report_.repair = repairReport(map());
    if (std::string note = orientationNote(report_.repair, options_.orient); !note.empty())
      report_.notes.push_back(std::move(note));
    surface_.boundaryLoops = std::vector<SurfaceLoop>();
    pool_ = std::make_unique<ThreadPool>(
        usefulThreads(options_.threads, surface_.table.triangles().size()));
    report_.threads = pool_->threads();
    pool_->listen(pulse_);
    return {};
  }

  void weldAndBuild(const PolygonMesh& mesh, bool byPosition, const VertexPairs& joined,
                    const Pulse& pulse) {
    if (!pulse.isStopped()) welded_ = weld(mesh, byPosition, pulse, joined);
    if (pulse.isStopped()) return;
    surface_ = buildSurface(welded_.mesh, pulse, [this](const CornerTable& table) {
      return fineLength(welded_, table, options_, unit_);
    });
  }

  Status cut() {
    asked_.upAxis = upAxis();
    asked_.breaks = hardEdges(map());
    Result<Seams> given = givenSeams(map(), options_.seams, asked_.breaks);
    if (!given.ok()) return given.status;
    addMaterialBorders(map(), asked_.breaks);
    asked_.seams = std::move(given.value);
    Scales& scales = asked_.scales;
    if (options_.seams.isAuto) scales = addScaleSeams(welded_.mesh, surface_, asked_.seams);
    if (scales.sharpest) report_.notes.push_back(scaleNote(*scales.sharpest, map(), unit_));
    Result<FixedTriangles> fixed = fixedTriangles(map(), options_);
    if (!fixed.ok()) return fixed.status;
    fixed_ = std::move(fixed.value);
    if (!fixed_.note.empty()) report_.notes.push_back(fixed_.note);
    stacks_.leaveOutComponents({surface_, fixed_, asked_.breaks, asked_.seams, scales});
    if (fixed_.isFixed.empty()) hideUnseen();
    Approach search(usualBeats(surface_.table.triangles().size()));
    open_ = cutOpen(
        uncut(), asked_, {}, options_, *pool_, [&] { return monitor_.tell(kSeams, search.next()); },
        report_.seams);
    if (canCut(options_) && fixed_.isFixed.empty())
      variants_ = variantsWorth(surface_.table.triangles().size(), shareInFront(open_.mesh));
    if (variants_.empty()) surface_.fans = Fans();
    monitor_.tellAgain();
    isSearching_ = !variants_.empty();
    return monitor_.stopped() ? Status() : takeCharts();
  }

  /// Until the layout is measured.
  void hideUnseen() {
    Smoothed smoothed = withoutUnseen(welded_, surface_, options_, unit_, pulse_);
    if (std::string note = unseenNote(smoothed); !note.empty())
      report_.notes.push_back(std::move(note));
    if (smoothed.triangles == 0) return;
    truePositions_ = std::move(welded_.mesh.positions);
    welded_.mesh.positions = std::move(smoothed.positions);
  }

  /// Whatever is reported from here on is told of the true surface.
  void showUnseen() {
    if (truePositions_.empty()) return;
    std::swap(welded_.mesh.positions, truePositions_);
    measureUnseen(charts_.set, stacks_.modelOf(), truePositions_, welded_.mesh.positions, *pool_,
                  charts_.flat);
    truePositions_ = std::vector<double>();
  }

  UncutSurface uncut() const { return {welded_, unit_, surface_, fixed_}; }

  Status flatten() {
    const auto tell = [&](double share) { return tellSolve(share); };
    if (Status s = flattenCut(tell); !s.ok()) return s;
    if (isSearching_)
      if (Status s = searchMore(); !s.ok()) return s;
    rectifyAll(
        options_, unit_, *pool_, [&] { return tell(1); }, charts_);
    return {};
  }

  /// Cuts the surface in other ways, too, and keeps what turns out best.
  Status searchMore() {
    constexpr int kMostFruitless = 3;
    FlatCut best{std::move(open_), std::move(charts_), {}};
    int fruitless = isSettled(options_, best) ? kMostFruitless : 0;
    for (const int variant : variants_) {
      if (fruitless >= kMostFruitless) break;
      if (Status s = cutAgain({variant, &best.open}); !s.ok() || monitor_.stopped()) return s;
      FlatCut other{std::move(open_), std::move(charts_), {}};
      const bool isBetter = takeBetter(welded_, options_, best, other);
      if (!isForFront(variant)) fruitless = isBetter ? 0 : fruitless + 1;
    }
    open_ = std::move(best.open);
    charts_ = std::move(best.charts);
    surface_.fans = Fans();
    if (Status s = joinSmall(); !s.ok()) return s;
    return layOutAsAsked();
  }

  /// Joins charts that are too small to be worth a seam, where the bounds allow it.
  Status joinSmall() {
    constexpr int kMostRounds = 6;
    SmallCharts small;
    for (int k = 0; k < kMostRounds && canCut(options_) && !monitor_.stopped(); ++k) {
      const Seams seams = small.join(charts_, options_, open_);
      if (seams.empty()) break;
      LaidCharts before;
      if (Status s = takeChartsAnew(before); !s.ok()) return s;
      if (Status s = layOut([&](double) { return monitor_.tellAgain(); }); !s.ok()) return s;
      if (monitor_.stopped()) break;
      if (Status s =
              takeBackTo(before, small.refused(before, charts_, options_, open_.mirror), seams);
          !s.ok())
        return s;
    }
    return {};
  }

  /// Searches take no notice of pins and of what is known, so that these change no seam.
  Status layOutAsAsked() {
    isSearching_ = false;
    LaidCharts solved = std::move(charts_);
    if (Status s = takeCharts(); !s.ok()) return s;
    if (Status s = takeKnown(cutMesh(), constraints_, options_, *pool_, charts_.flat); !s.ok())
      return s;
    for (const ChartId i : charts_.set.ids())
      if (!constraints_[i].pins.empty()) solved.flat[i] = FlatChart();
    moveSame(solved, charts_);
    return flattenCut([&](double) { return monitor_.tellAgain(); });
  }

  Status cutAgain(const SeamVariant& variant) {
    const auto goesOn = [&] { return monitor_.tellAgain(); };
    SeamSummary summary;  // that of the first search holds
    report_.timings.solve += watch_.lap();
    open_ = cutOpen(uncut(), asked_, variant, options_, *pool_, goesOn, summary);
    report_.timings.seams += watch_.lap();
    if (monitor_.stopped()) return {};
    if (Status s = takeCharts(); !s.ok()) return s;
    return flattenCut([&](double) { return goesOn(); });
  }

  /// Flattens all charts, and cuts those further that are stretched more than predicted.
  Status flattenCut(const std::function<bool(double)>& tell) {
    if (Status s = layOutFixed(cutMesh(), fixed_, options_, charts_.flat); !s.ok()) return s;
    if (Status s = checkUnpinned(charts_.set, constraints_, charts_.flat); !s.ok()) return s;
    if (Status s = layOut(tell); !s.ok()) return s;
    constexpr int kMostRounds = 8;
    if (Status s = cutWhileStretched(kMostRounds, report_.timings.solve, tell); !s.ok()) return s;
    if (Status s = endSearch(tell); !s.ok()) return s;
    return halveRuined(report_.timings.solve, tell);
  }

  /// Tries more on charts for which no seam was found.
  Status endSearch(const std::function<bool(double)>& tell) {
    for (FlatChart& chart : charts_.flat) chart.isCutEnough = true;
    return dropGivenUp(charts_.flat) ? layOut(tell) : Status();
  }

  /// Splits charts in two that are still far from what is asked for. A chart that cannot be split
  /// gets the layout that is always valid.
  Status halveRuined(double& seconds, const std::function<bool(double)>& tell) {
    constexpr int kMostHalvings = 24, kMostRounds = 4;
    for (int k = 0; canCut(options_) && k < kMostHalvings && !monitor_.stopped(); ++k) {
      bool isAny = false;
      if (Status s = halve(ruinedCharts(charts_.flat, options_.maxStretch), isAny); !s.ok())
        return s;
      if (!isAny) break;
      if (Status s = layOut(tell); !s.ok()) return s;
      expectScale(charts_.set, stretchedPieces(charts_.flat, options_), *pool_, open_);
      if (Status s = cutWhileStretched(kMostRounds, seconds, tell); !s.ok()) return s;
      if (Status s = endSearch(tell); !s.ok()) return s;
    }
    return dropGivenUp(charts_.flat) ? layOut(tell) : Status();
  }

  /// Splits the charts in two, and marks those that cannot be split. `isAny`: whether some were.
  Status halve(const IdVector<ChartId, std::uint8_t>& isAsked, bool& isAny) {
    IdVector<ChartId, std::uint8_t> isWhole;
    isAny = abflat::halve(charts_.set, isAsked, options_, open_, isWhole);
    for (const ChartId i : isWhole.ids()) charts_.flat[i].isWhole |= isWhole[i] != 0;
    return isAny ? takeChartsAnew() : Status();
  }

  /// Each round fills a share of the bar that the rounds before left.
  bool tellSolve(double share) {
    constexpr double kFirst = 0.7;
    return monitor_.tell(kSolve, 1 - std::pow(1 - kFirst, round_) * (1 - kFirst * share));
  }

  /// Repeats as long as it helps. `seconds`: time spent on layouts.
  Status cutWhileStretched(int mostRounds, double& seconds,
                           const std::function<bool(double)>& tell) {
    for (round_ = 1; round_ <= mostRounds && !monitor_.stopped(); ++round_) {
      seconds += watch_.lap();
      const bool isCut = cutFurther([&] { return tell(0); });
      report_.timings.seams += watch_.lap();
      if (!isCut || monitor_.stopped()) break;
      if (Status s = takeChartsAnew(); !s.ok()) return s;
      dropGivenUp(charts_.flat);
      if (Status s = layOut(tell); !s.ok()) return s;
    }
    return {};
  }

  bool cutFurther(const std::function<bool()>& goesOn) {
    if (!canCut(options_)) return false;
    IdVector<ChartId, Stretched> charts;
    for (const FlatChart& chart : charts_.flat) {
      const bool isAsked =
          (chart.isGivenUp() || isStretched(chart, options_)) && !chart.isCutEnough;
      charts.push_back({isAsked ? stretchOf(chart.distortion, options_) : 0, chart.isGivenUp()});
    }
    const Further done = cutStretched(charts_.set, charts, options_, *pool_, goesOn, open_);
    // Charts whose layout is kept have been tried.
    for (const ChartId i : charts.ids())
      charts_.flat[i].isCutEnough |= done != Further::Replaced && charts[i].stretch > 0;
    return done != Further::Nothing;
  }

  /// The charts of the surface with its present seams, none of which is laid out.
  Status takeCharts() {
    charts_ = {chartsOf(welded_, open_), {}};
    charts_.flat.resize(charts_.set.size());
    return readConstraints();
  }

  /// The same, but what has not changed keeps its layout. `before`: the charts until now, and
  /// what is left of their layouts.
  Status takeChartsAnew(LaidCharts& before) {
    before = std::move(charts_);
    Status s = takeCharts();
    moveSame(before, charts_);
    return s;
  }

  /// The same, where nothing else is needed of the charts until now.
  Status takeChartsAnew() {
    LaidCharts before;
    return takeChartsAnew(before);
  }

  Status readConstraints() {
    monitor_.tellAgain();
    texcoords_ = numberTexcoords(cutMesh());
    if (isSearching_) {
      constraints_.assign(charts_.set.size(), {});
      return {};
    }
    Result<IdVector<ChartId, ChartConstraints>> constraints =
        chartConstraints(cutMesh(), texcoords_, fixed_, options_);
    if (!constraints.ok()) return constraints.status;
    constraints_ = std::move(constraints.value);
    return {};
  }

  /// Lays out charts that have no layout yet.
  Status layOut(const std::function<bool(double)>& tell) {
    if (!isSearching_)
      if (Status s = takeKnown(cutMesh(), constraints_, options_, *pool_, charts_.flat); !s.ok())
        return s;
    flattenAll(constraints_, options_, *pool_, monitor_, tell, charts_);
    return {};
  }

  Status packCharts() {
    if (Status s = checkPinned(cutMesh(), options_, charts_.flat); !s.ok()) return s;
    if (stacks_.leaveOutCharts(constraints_, {surface_, fixed_, open_, charts_}))
      if (Status s = readConstraints(); !s.ok()) return s;
    const FlatCharts& flat = charts_.flat;
    const bool mayCut = cutModeOf(options_, flat, 0) != CutMode::None;
    Status s = packNow(0, mayCut ? kUncut : 1);
    if (s.ok() && mayCut) s = cutForPacking();
    if (s.ok()) s = keepPartsApart();
    if (s.ok() && !monitor_.stopped()) s = fitToFile();
    if (!s.ok()) return s;
    for (std::string note : {utilizationNote(packedCharts(), map(), options_, report_.atlas),
                             spacingNote(cutMesh(), charts_.flat, nearParts(), options_)})
      if (!note.empty()) report_.notes.push_back(std::move(note));
    endCutting();
    return s;
  }

  /// What lies nearer to another part of its chart than the padding.
  IdVector<ChartId, NearParts> nearParts() { return nearPartsOf(packedCharts(), options_); }

  /// Cuts charts whose parts are too near each other, and packs again, unless that does not fit.
  Status keepPartsApart() {
    constexpr int kMostRounds = 4;
    for (int k = 0; k < kMostRounds && canCut(options_) && !monitor_.stopped(); ++k) {
      open_.seams.resize(open_.mesh.twin.size(), 0);
      Seams seams = open_.seams;
      if (!cutBetween(charts_, nearParts(), options_, open_)) break;
      PackedState before{{}, std::move(seams), std::move(packing_), report_.atlas};
      if (Status s = takeChartsAnew(before.charts); !s.ok()) return s;
      takePieces(before.charts, options_, *pool_, charts_);
      const auto goesOn = [&] { return monitor_.tellAgain(); };
      if (Status s = layOutPieces(goesOn); !s.ok() || monitor_.stopped()) return s;
      Status packed = packNow(1, 1);
      if (packed.code == StatusCode::AtlasTooSmall) return restore(before);
      if (!packed.ok()) return packed;
    }
    return {};
  }

  /// Rounds the atlas as its file does. Charts that this makes invalid are split in two, and all
  /// are packed again.
  Status fitToFile() {
    constexpr int kMostSplits = 6;
    for (int k = 0; !monitor_.stopped(); ++k) {
      std::vector<std::string> notes = checkAll(packedCharts(), options_, report_.atlas);
      bool isSplit = false;
      if (k < kMostSplits && canCut(options_))
        if (Status s = halve(ruinedCharts(charts_.flat, HUGE_VAL), isSplit); !s.ok()) return s;
      if (!isSplit) {
        for (std::string& note : notes) report_.notes.push_back(std::move(note));
        return {};
      }
      const auto tell = [&](double) { return monitor_.tellAgain(); };
      if (Status s = layOut(tell); !s.ok()) return s;
      if (Status s = endSearch(tell); !s.ok()) return s;
      if (Status s = packNow(1, 1); !s.ok()) return s;
    }
    return {};
  }

  /// Packs, which takes the given range of the stage's progress.
  Status packNow(double from, double to) {
    const auto tell = [&, from, to](double share) {
      return monitor_.tell(kPack, from + (to - from) * share);
    };
    return packAll(packedCharts(), options_, tell, report_.atlas);
  }

  /// Cuts charts if that makes the packing so much denser that it is worth the seams; otherwise
  /// leaves them as they were.
  Status cutForPacking() {
    const auto goesOn = [&] { return monitor_.tell(kPack, kUncut); };
    const CutsForPacking cuts =
        findCutsForPacking(packedCharts(), open_, options_, report_.atlas.utilization, goesOn);
    if (cuts.halfEdges.empty() || monitor_.stopped()) return {};
    open_.seams.resize(open_.mesh.twin.size(), 0);
    Seams seams = open_.seams;
    const double length = seamLength(open_), cost = seamCost(open_);
    addCuts(cuts, options_, open_);
    PackedState before{{}, std::move(seams), std::move(packing_), report_.atlas};
    if (Status s = takeChartsAnew(before.charts); !s.ok()) return s;
    // Where they lie, their new ends need not be straight.
    if (!options_.straightSeams) takePieces(before.charts, options_, *pool_, charts_);
    if (Status s = layOutPieces(goesOn); !s.ok() || monitor_.stopped()) return s;
    if (Status s = joinStretched(before.charts, before.seams); !s.ok()) return s;
    report_.atlas.packingCuts = static_cast<int>(charts_.set.size() - before.charts.set.size());
    report_.atlas.packingCutLength = seamLength(open_) - length;
    report_.atlas.uncutTexelDensity = before.atlas.texelDensity;
    Status packed = packNow(kUncut, 1);
    if (packed.code == StatusCode::Aborted) return packed;
    if (packed.ok() && isWorth(report_.atlas, seamCost(open_) - cost, options_))
      return stackPieces();
    return restore(before);
  }

  /// Packs again if some of the pieces are alike.
  Status stackPieces() {
    if (!stacks_.leaveOutCharts(constraints_, {surface_, fixed_, open_, charts_})) return {};
    Status s = readConstraints();
    return s.ok() ? packNow(1, 1) : s;
  }

  /// What a cut of packed charts changes, as it was before.
  struct PackedState {
    LaidCharts charts;
    Seams seams;
    Packing packing;
    AtlasReport atlas;
  };

  Status restore(PackedState& before) {
    moveSame(charts_, before.charts);
    charts_ = std::move(before.charts);
    open_.seams = std::move(before.seams);
    packing_ = std::move(before.packing);
    report_.atlas = before.atlas;
    placeInAtlas(packing_, charts_.flat);
    return readConstraints();
  }

  /// Lays out the pieces that cannot keep their place in the former chart's layout. Pieces that are
  /// still stretched too much are cut further.
  Status layOutPieces(const std::function<bool()>& goesOn) {
    constexpr int kMostRounds = 3;
    const auto tell = [&](double) { return goesOn(); };
    if (Status s = layOut(tell); !s.ok()) return s;
    expectScale(charts_.set, stretchedPieces(charts_.flat, options_), *pool_, open_);
    if (Status s = cutWhileStretched(kMostRounds, report_.timings.pack, tell); !s.ok()) return s;
    return endSearch(tell);
  }

  /// Joins charts again that were cut for packing into pieces with too much stretch.
  Status joinStretched(LaidCharts& before, const Seams& seams) {
    return takeBackTo(before, stretchedByCuts(before, charts_, options_), seams);
  }

  /// Takes back what was changed about these charts.
  Status takeBackTo(LaidCharts& before, const IdVector<ChartId, std::uint8_t>& isAsked,
                    const Seams& seams) {
    if (std::find(isAsked.begin(), isAsked.end(), 1) == isAsked.end()) return {};
    takeBack(before.set, isAsked, seams, open_);
    Status s = takeChartsAnew();
    moveSame(before, charts_);
    return s;
  }

  /// Keeps only what the result needs of the cut surface. With many charts the rest takes most of
  /// the memory.
  void endCutting() {
    monitor_.tellAgain();
    if (std::string note = asymmetryNote(open_, options_); !note.empty())
      report_.notes.push_back(std::move(note));
    measureStraight(charts_.set, charts_.flat);
    Seams seams;
    if (stacks_.isAny()) {
      seams = stacks_.addAgain({surface_, fixed_, open_, charts_});
      texcoords_ = numberTexcoords(cutMesh());
      measureSeams(truePositions_.empty() ? welded_.mesh.positions : truePositions_, surface_.table,
                   seams, report_.seams);
    } else {
      seams = visibleSeams(open_);
      measureSeams(open_, seams, report_.seams);
    }
    report_.seams.symmetric = static_cast<bool>(open_.mirror);
    nameShapes(charts_.set, charts_.flat);
    out_.seams = seamEdges(map(), seams);
    open_ = OpenSurface();
    constraints_ = IdVector<ChartId, ChartConstraints>();
    charts_.set.eliminationRank = {};
  }

  Status finish() {
    packing_ = Packing();
    noteStretched(cutMesh(), charts_.flat, options_, report_.notes);
    showUnseen();
    fillTexcoords(texcoords_, unit_, charts_.flat, out_);
    giveBackFreeMemory();
    fillReport(cutMesh(), charts_.flat, unit_, report_);
    charts_.flat = FlatCharts();
    fillFaces(cutMesh(), texcoords_, out_);
    monitor_.tellAgain();
    charts_.set = ChartSet();
    surface_ = Surface();
    texcoords_ = Texcoords();
    certify(input_, welded_, options_.roundsForGltf ? Numbers::Gltf : Numbers::Double, out_);
    stacks_.check(report_);
    if (options_.roundsForGltf) return {};
    if (std::string note = foldedFansNote(input_, out_); !note.empty())
      report_.notes.push_back(std::move(note));
    return {};
  }

  const PolygonMesh& input_;
  const UnwrapOptions& options_;
  WeldedMesh welded_;
  Stacks stacks_;
  const double unit_;
  Stopwatch watch_;
  Monitor monitor_;
  const Pulse pulse_{[this] { return monitor_.tellAgain(); }};
  UnwrapResult out_;
  UnwrapReport& report_ = out_.report;
  std::vector<double> truePositions_;  ///< positions of the welded mesh, if it has others meanwhile
  Surface surface_;
  std::unique_ptr<ThreadPool> pool_;
  AskedCuts asked_;
  FixedTriangles fixed_;
  OpenSurface open_;
  LaidCharts charts_;
  Texcoords texcoords_;
  IdVector<ChartId, ChartConstraints> constraints_;
  std::vector<int> variants_;            ///< of costs, for further searches
  bool isSearching_ = false;             ///< for seams, of which the best are taken
  int round_ = 0;                        ///< of flattening
  static constexpr double kUncut = 0.6;  ///< share of packing before charts may be cut for it
  Packing packing_;
};

Result<UnwrapResult> unwrapInUnits(const PolygonMesh& mesh, const UnwrapOptions& options,
                                   int exponent) {
  return untilStacksFit(mesh.faceCount(), [&](UnfitFaces& unfit) {
    return Unwrapping(mesh, options, exponent, unfit).run();
  });
}

Result<UnwrapResult> unwrapAsItIs(const PolygonMesh& mesh, const UnwrapOptions& options) {
  // So that nothing overflows or is lost below, and results are the same in every unit.
  const int exponent = exponentOf(mesh);
  if (exponent == 0 || options.known.unpacked.empty())
    return unwrapInUnits(mesh, options, exponent);
  UnwrapOptions inUnits = options;
  for (double& x : inUnits.known.unpacked) x = std::ldexp(x, -exponent);
  return unwrapInUnits(mesh, inUnits, exponent);
}

}  // namespace

Result<UnwrapResult> unwrap(const PolygonMesh& mesh, const UnwrapOptions& options) {
  return guarded([&]() -> Result<UnwrapResult> {
    if (Status s = validateArrays(mesh); !s.ok()) return s;
    return options.orient ? unwrapTurned(mesh, options, unwrapAsItIs) : unwrapAsItIs(mesh, options);
  });
}

}  // namespace abflat
