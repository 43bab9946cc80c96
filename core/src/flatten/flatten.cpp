#include "abflat/flatten.h"

#include <algorithm>
#include <cmath>

#include "abflat/mesh.h"
#include "base/parallel.h"
#include "base/stopwatch.h"
#include "boundary/requested_bounds.h"
#include "chart/disk_chart.h"
#include "flatten/chart_report.h"
#include "flatten/chosen_solver.h"
#include "flatten/flatten_chart.h"
#include "flatten/refine_chart.h"
#include "mesh/surface.h"
#include "pin/chart_pins.h"

namespace abflat {
namespace {

/// Tells the caller where a run is, and remembers when it asked to stop.
class Monitor {
 public:
  explicit Monitor(const ProgressCallback& callback) : callback_(callback) {}

  bool tell(Stage stage, double fraction) {
    last_.stage = stage;
    last_.fraction = std::max(last_.fraction, fraction);
    if (callback_ && !stopped_ && !callback_(last_)) stopped_ = true;
    return !stopped_;
  }

  /// Convergence is quadratic and takes 3 to 10 steps on most charts: the bar slows down after
  /// that.
  bool tellStep(const NewtonStep& now) {
    last_.constraintResidual = now.constraint;
    ++last_.newtonStep;
    return tell(Stage::Solve, share());
  }

  bool tellStage(Stage stage) { return tell(stage, share()); }
  bool stopped() const { return stopped_; }

 private:
  double share() const { return 0.05 + 0.85 * (1 - std::exp(-last_.newtonStep / 5.0)); }

  const ProgressCallback& callback_;
  Progress last_;
  bool stopped_ = false;
};

/// The only chart is the surface: its vertices are texcoords. Nothing is welded, so polygons are
/// those of the input.
Texcoords texcoordsOf(const PolygonMesh& mesh, const Surface& surface) {
  Texcoords out;
  out.ofCorner.resize(mesh.faceVertices.size());
  for (const SurfaceCorner c : surface.table.corners()) {
    const PolygonCorner corner = surface.triangulation.corner[c];
    out.ofCorner[InputCorner(std::uint32_t{corner})] =
        TexcoordId(std::uint32_t{surface.fans.ofCorner[c]});
  }
  out.firstOf = {TexcoordId(0), TexcoordId(surface.fans.inputVertex.size())};
  return out;
}

/// All that is needed of a mesh. The connectivity that it comes from takes much memory and is gone
/// before the solver needs its own.
struct Prepared {
  MeshSummary summary;
  DiskChart chart;
  Texcoords texcoords;
};

Result<Prepared> prepare(const PolygonMesh& mesh, const Pulse& pulse) {
  Surface surface = buildSurface(mesh, pulse);
  if (pulse.isStopped()) return Status{StatusCode::Aborted, "cancelled"};
  if (!surface.summary.disk.ok()) return surface.summary.disk;
  Prepared out;
  out.chart = makeDiskChart(mesh, surface);
  out.texcoords = texcoordsOf(mesh, surface);
  out.summary = std::move(surface.summary);
  return out;
}

}  // namespace

Result<FlattenResult> flatten(const PolygonMesh& mesh, const FlattenOptions& options) {
  Stopwatch watch;
  Monitor monitor(options.progress);
  const Status aborted{StatusCode::Aborted, "cancelled"};
  const Result<SolverChoice> chosen = chosenSolver(options);
  if (!chosen.ok()) return chosen.status;
  if (options.delaunay && options.balance > 0)
    return Status{
        StatusCode::InvalidOption,
        "delaunay is a condition on angles, which a balance above 0 changes. Use only one of "
        "them"};
  if (Status s = validateArrays(mesh); !s.ok()) return s;
  if (!monitor.tell(Stage::Connectivity, 0)) return aborted;

  Result<Prepared> prepared =
      prepare(mesh, Pulse([&] { return monitor.tell(Stage::Connectivity, 0); }));
  if (!prepared.ok()) return prepared.status;
  const DiskChart& chart = prepared.value.chart;
  Result<StraightPlaces> straight = straightPlaces(chart, options.straight);
  if (!straight.ok()) return straight.status;
  const Result<BoundaryBounds> t = requestedBounds(chart, options, straight.value);
  if (!t.ok()) return t.status;
  const Result<IdVector<ChartId, std::vector<ChartPin>>> pins =
      pinsOfCharts(mesh, prepared.value.texcoords, options.pins);
  if (!pins.ok()) return pins.status;
  FlattenResult out;
  Timings& timings = out.report.timings;
  const double connectivity = watch.lap();

  if (!monitor.tellStage(Stage::Solve)) return aborted;
  ThreadPool pool(usefulThreads(options.threads, chart.triangleCount()));
  SolverOptions solver;
  solver.pool = &pool;
  solver.onStep = [&](int, const NewtonStep& now) { return monitor.tellStep(now); };
  solver.allowedBytes = allowedBytes(options.memory);
  ChartFlattener flattener(
      chart, solver, [&](Stage stage) { monitor.tellStage(stage); }, chosen.value);
  flattener.requireStraight(std::move(straight.value));
  const double setUp = watch.lap();
  const RefineWishes refining{
      options.balance,     t.value, pins.value.front(),
      solver.allowedBytes, &pool,   [&] { return monitor.tellStage(Stage::Refine); }};
  Attempt best = refining.pins.empty() ? flattenAndRefine(flattener, t.value, options, {}, refining)
                                       : flattenChart(flattener, t.value, options);
  if (!refining.pins.empty()) {
    pin(flattener, refining.pins, {solver.allowedBytes, &pool}, best);
    refineChart(flattener, refining, best);
  }
  if (best.solution.cancelled || monitor.stopped()) return aborted;
  if (best.pins)
    if (const Exceeded e = exceededBounds(chart, best.uv, t.value); e.count > 0)
      best.fallbacks.push_back("pins: " + exceededText(e));
  timings = flattener.timings();
  timings.solve += setUp;
  timings.connectivity = connectivity;

  if (!monitor.tell(Stage::Check, 0.92)) return aborted;
  watch.lap();
  out.uv = inMeshUnit(chart, best);
  const double common = *std::max_element(best.t.begin(), best.t.end());
  out.report.charts.push_back(makeChartReport(chart, best, common));
  timings.check += watch.lap();

  out.report.input = std::move(prepared.value.summary);
  out.report.options = options;
  out.report.threads = pool.threads();
  out.report.valid = out.report.charts.front().valid;
  out.vertexMap.assign(chart.inputVertex.begin(), chart.inputVertex.end());
  out.triangles.assign(chart.vertexOfCorner.begin(), chart.vertexOfCorner.end());
  const auto& ofCorner = prepared.value.texcoords.ofCorner;
  out.cornerUv.assign(ofCorner.begin(), ofCorner.end());
  out.straight = straightVertices(chart, flattener.straight());
  return out;
}

}  // namespace abflat
