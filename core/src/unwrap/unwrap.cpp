#include "abflat/unwrap.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "abflat/mesh.h"
#include "abflat/peak_memory.h"
#include "base/free_memory.h"
#include "base/guarded.h"
#include "base/listener.h"
#include "base/parallel.h"
#include "cut/front.h"
#include "mesh/input_mesh.h"
#include "mesh/surface_map.h"
#include "seam/given_seams.h"
#include "unwrap/asked_parts.h"
#include "unwrap/certificate.h"
#include "unwrap/chart_shapes.h"
#include "unwrap/cut_open.h"
#include "unwrap/densities.h"
#include "unwrap/flatten_cut.h"
#include "unwrap/layouts.h"
#include "unwrap/measure_seams.h"
#include "unwrap/output.h"
#include "unwrap/pack_cut.h"
#include "unwrap/read_surface.h"
#include "unwrap/rectify.h"
#include "unwrap/seam_notes.h"
#include "unwrap/search.h"
#include "unwrap/stacks.h"
#include "unwrap/stage_span.h"
#include "unwrap/stage_times.h"
#include "unwrap/turned.h"
#include "unwrap/unseen.h"
#include "unwrap/variants.h"

namespace abflat {
namespace {

std::size_t upAxisOf(const InputMesh& input, Up up) {
  return up == Up::Z || (up == Up::Auto && input.extras().isZUp) ? 2 : 1;
}

Status checkInput(const InputMesh& input, const UnwrapOptions& options) {
  if (options.udim && options.texelDensity == kAutoTexelDensity)
    return {StatusCode::InvalidOption, "udim needs a numeric texel density"};
  if (options.packingCuts == PackingCuts::Never && options.minUtilization > 0)
    return {StatusCode::InvalidOption,
            "with packingCuts = never all charts stay whole, so minUtilization has no effect; "
            "leave one of them out"};
  if (input.faceCount() == 0) return {StatusCode::EmptyMesh, "the mesh has no faces"};
  return checkDensities(options.faceDensities, input.faceCount());
}

/// The stages of a run, one after the other.
class Stages {
 public:
  Stages(const Listener& listener, UnwrapReport& report)
      : listener_(listener), report_(report), times_(report.timings) {}

  /// Ends the stage before, if there is one. False if the run is to end.
  bool enter(const StageSpan& span) { return end() && begin(span); }

  bool end() {
    if (listener_.isStopped()) return false;
    if (!field_) return true;
    times_.book(field_);
    report_.peakMemory.*field_ = peakMemory();
    giveBackFreeMemory();
    return true;
  }

  StageTimes& times() { return times_; }

 private:
  bool begin(const StageSpan& span) {
    field_ = span.field;
    return span.of(listener_).tell();
  }

  const Listener& listener_;
  UnwrapReport& report_;
  StageTimes times_;
  double UnwrapStages::*field_ = nullptr;  ///< of the present one
};

Status aborted() { return {StatusCode::Aborted, "cancelled"}; }

/// Smooths what texels cannot show until the layout is measured. Returns the true positions; empty
/// if nothing is smoothed.
std::vector<double> hideUnseen(WeldedSurface& read, const UnwrapOptions& options, double unit,
                               const Listener& listener, std::vector<std::string>& notes) {
  Smoothed smoothed = withoutUnseen(read.welded, read.surface, options, unit, listener);
  if (std::string note = unseenNote(smoothed); !note.empty()) notes.push_back(std::move(note));
  if (smoothed.triangles == 0) return {};
  std::swap(read.welded.mesh.positions, smoothed.positions);
  return std::move(smoothed.positions);
}

/// Describes seams and charts, and keeps only what the result needs of the cut surface. With many
/// charts the rest takes most of the memory.
void endCutting(const SurfaceMap& map, const std::vector<double>& truePositions, Stacks& stacks,
                const CutParts& parts, const UnwrapOptions& options, UnwrapResult& out) {
  SeamSummary& summary = out.report.seams;
  if (std::string note = asymmetryNote(parts.open, options); !note.empty())
    out.report.notes.push_back(std::move(note));
  measureStraight(parts.charts.set, parts.charts.flat);
  Seams seams;
  if (stacks.isAny()) {
    seams = stacks.addAgain(parts);
    const std::vector<double>& smoothed = map.welded().mesh.positions;
    measureSeams(truePositions.empty() ? smoothed : truePositions, parts.surface.table, seams,
                 summary);
  } else {
    seams = visibleSeams(parts.open);
    measureSeams(parts.open, seams, summary);
  }
  summary.symmetric = static_cast<bool>(parts.open.mirror);
  nameShapes(parts.charts.set, parts.charts.flat);
  out.seams = seamEdges(map, seams);
  parts.open = OpenSurface();
  parts.charts.set.eliminationRank = {};
}

/// Moves the charts to the result.
void fillResult(const SurfaceMap& map, double unit, LaidCharts& charts, UnwrapResult& out) {
  const CutMesh mesh{map, charts.set};
  const Texcoords texcoords = numberTexcoords(mesh);
  fillTexcoords(texcoords, unit, charts.flat, out);
  giveBackFreeMemory();
  fillReport(mesh, charts.flat, unit, out.report);
  charts.flat = FlatCharts();
  fillFaces(mesh, texcoords, out);
}

/// One run, stage by stage. The mesh and lengths in the options are scaled to units of 2^exponent.
Result<UnwrapResult> unwrapInUnits(const InputMesh& input, const UnwrapOptions& options,
                                   int exponent, const Listener& listener, UnfitFaces& unfit) {
  if (Status s = checkInput(input, options); !s.ok()) return s;
  const double unit = std::ldexp(1.0, exponent);
  const std::size_t upAxis = upAxisOf(input, options.up);
  UnwrapResult out;
  UnwrapReport& report = out.report;
  report.options = options;
  Stages stages(listener, report);

  if (!stages.enter(kSurface)) return aborted();
  Result<WeldedSurface> read = readSurface(input, options, unit, kSurface.of(listener), report);
  if (!read.ok()) return read.status();
  if (listener.isStopped()) return aborted();
  WeldedMesh& welded = read.value().welded;
  Surface& surface = read.value().surface;
  const SurfaceMap map(input, welded, surface);
  ThreadPool pool(usefulThreads(options.threads, surface.table.triangles().size()));
  report.threads = pool.threads();
  pool.listen(listener);

  if (!stages.enter(kSeams)) return aborted();
  Result<AskedParts> asked = askedParts(map, options, unit, upAxis, report.notes);
  if (!asked.ok()) return asked.status();
  AskedCuts& cuts = asked.value().cuts;
  FixedTriangles& fixed = asked.value().fixed;
  Stacks stacks(input, welded, options, unfit);
  stacks.leaveOutComponents({surface, fixed, cuts.breaks, cuts.seams, cuts.scales});
  std::vector<double> truePositions;
  if (fixed.isFixed.empty())
    truePositions = hideUnseen(read.value(), options, unit, listener, report.notes);
  const UncutSurface uncut{welded, unit, surface, fixed};
  const std::size_t triangles = surface.table.triangles().size();
  const bool isSearched = canCut(options) && fixed.isFixed.empty();
  Passes passes(listener, triangles);
  passes.next(isSearched ? expectedSearches(triangles) : 0);
  FlatCut cut;
  cut.open = cutOpen(uncut, cuts, {}, options, pool, passes.seams().at(Stage::Seams), report.seams);
  std::vector<SeamVariant> variants;
  if (isSearched)
    variants = variantsWorth(triangles, shareInFront(cut.open.mesh), hasMask(cut.open));
  passes.expect(expectedSearches(variants, cut.open));
  if (variants.empty()) surface.fans = Fans();
  listener.tell();
  if (listener.isStopped()) return aborted();
  FlattenSettings settings{map,           fixed, options, pool, passes.layouts().at(Stage::Solve),
                           stages.times()};
  settings.isSearch = !variants.empty();
  const CutFlattener flattener(settings);
  if (Status s = flattener.takeCharts(cut); !s.ok()) return s;

  if (!stages.enter(kSolve)) return aborted();
  if (Status s = flattener.flatten(cut); !s.ok()) return s;
  settings.isSearch = false;
  settings.listener = kSolve.of(listener).part(0, 0);  // of the rest only searches take a share
  if (!variants.empty())
    if (Status s = searchMore({uncut, cuts}, variants, settings, passes, cut); !s.ok()) return s;
  surface.fans = Fans();
  rectifyAll(options, unit, pool, settings.listener, cut.charts);

  if (!stages.enter(kPack)) return aborted();
  settings.stage = &UnwrapStages::pack;
  settings.listener = kPack.of(listener).part(0, 0);
  if (Status s = packCut(CutFlattener(settings), {unit, upAxis, truePositions, kPack.of(listener)},
                         stacks, surface, fixed, cut, report);
      !s.ok())
    return s;
  if (listener.isStopped()) return aborted();
  endCutting(map, truePositions, stacks, {surface, fixed, cut.open, cut.charts}, options, out);
  cut.constraints = IdVector<ChartId, ChartConstraints>();

  if (!stages.enter(kCheck)) return aborted();
  noteStretched({map, cut.charts.set}, cut.charts.flat, options, report.notes);
  if (!truePositions.empty()) {
    std::swap(welded.mesh.positions, truePositions);
    measureUnseen(cut.charts.set, stacks.modelOf(), truePositions, welded.mesh.positions, pool,
                  cut.charts.flat);
  }
  fillResult(map, unit, cut.charts, out);
  listener.tell();
  cut.charts.set = ChartSet();
  surface = Surface();
  certify(input, welded, options.precision == Precision::Gltf ? Numbers::Gltf : Numbers::Double,
          out);
  stacks.check(report);
  if (options.precision != Precision::Gltf)
    if (std::string note = foldedFansNote(input, out); !note.empty())
      report.notes.push_back(std::move(note));
  if (!stages.end()) return aborted();
  return out;
}

Result<UnwrapResult> unwrapScaled(const InputMesh& mesh, const UnwrapOptions& options, int exponent,
                                  const Listener& listener) {
  return untilStacksFit(mesh.faceCount(), [&](UnfitFaces& unfit) {
    return unwrapInUnits(mesh, options, exponent, listener, unfit);
  });
}

Result<UnwrapResult> unwrapAsItIs(const InputMesh& mesh, const UnwrapOptions& options,
                                  const Listener& listener) {
  // So that nothing overflows or is lost below, and results are the same in every unit.
  const int exponent = exponentOf(mesh);
  if (exponent == 0 || options.reuse.known.unpacked.empty())
    return unwrapScaled(mesh, options, exponent, listener);
  UnwrapOptions inUnits = options;
  for (double& x : inUnits.reuse.known.unpacked) x = std::ldexp(x, -exponent);
  return unwrapScaled(mesh, inUnits, exponent, listener);
}

Result<UnwrapResult> unwrapInput(const InputMesh& mesh, const UnwrapOptions& options) {
  return guarded([&]() -> Result<UnwrapResult> {
    if (Status s = mesh.validate(); !s.ok()) return s;
    const Listener listener(options.progress);
    return options.orient ? unwrapTurned(mesh, options, listener, unwrapAsItIs)
                          : unwrapAsItIs(mesh, options, listener);
  });
}

}  // namespace

Result<UnwrapResult> unwrap(const PolygonMesh& mesh, const UnwrapOptions& options) {
  return unwrapInput(mesh, options);
}

Result<UnwrapResult> unwrap(const MeshView& mesh, const UnwrapOptions& options) {
  return unwrapInput(mesh, options);
}

}  // namespace abflat
