#include "abflat/flatten.h"

#include <algorithm>

#include "base/guarded.h"
#include "base/listener.h"
#include "base/parallel.h"
#include "base/stopwatch.h"
#include "boundary/requested_bounds.h"
#include "chart/disk_chart.h"
#include "flatten/chart_report.h"
#include "flatten/chosen_solver.h"
#include "flatten/flatten_chart.h"
#include "flatten/refine_chart.h"
#include "mesh/input_mesh.h"
#include "mesh/surface.h"
#include "pin/chart_pins.h"

namespace abflat {
namespace {

/// The surface is the only chart, so its vertices are the texcoords. Nothing is welded: polygons
/// are those of the input.
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

/// All that is needed of a mesh. The connectivity it is built from takes much memory and is freed
/// before the solver needs its own.
struct Prepared {
  MeshSummary summary;
  DiskChart chart;
  Texcoords texcoords;
};

Result<Prepared> prepare(const InputMesh& input, const Listener& listener) {
  if (!input.polygons()) return prepare(input.copy(), listener);  // freed with the connectivity
  const PolygonMesh& mesh = *input.polygons();
  Surface surface = buildSurface(mesh, listener);
  if (listener.isStopped()) return Status{StatusCode::Aborted, "cancelled"};
  if (!surface.summary.disk.ok()) return surface.summary.disk;
  Prepared out;
  out.chart = makeDiskChart(mesh, surface);
  out.texcoords = texcoordsOf(mesh, surface);
  out.summary = std::move(surface.summary);
  return out;
}

/// One run, stage by stage.
class Flattening {
 public:
  Flattening(const InputMesh& mesh, const FlattenOptions& options)
      : mesh_(mesh), options_(options), listener_(options.progress) {}

  Result<FlattenResult> run() {
    if (Status s = check(); !s.ok()) return s;
    if (Status s = seeDisk(); !s.ok()) return s;
    if (Status s = readConstraints(); !s.ok()) return s;
    if (Status s = layOut(); !s.ok()) return s;
    finish();
    return std::move(out_);
  }

 private:
  /// Shares of the progress bar before the solver begins, and once the layout is found.
  static constexpr double kConnectivity = 0.05, kSolved = 0.92;

  static Status aborted() { return {StatusCode::Aborted, "cancelled"}; }

  Status check() {
    Result<SolverChoice> chosen = chosenSolver(options_);
    if (!chosen.ok()) return chosen.status();
    choice_ = std::move(chosen.value());
    if (options_.delaunay && options_.balance > 0)
      return {StatusCode::InvalidOption,
              "delaunay is a condition on angles, which a balance above 0 changes. Use only one of "
              "them"};
    return mesh_.validate();
  }

  Status seeDisk() {
    const Listener listener = listener_.part(Stage::Connectivity, 0, kConnectivity);
    if (!listener.tell()) return aborted();
    Result<Prepared> prepared = prepare(mesh_, listener);
    if (!prepared.ok()) return prepared.status();
    prepared_ = std::move(prepared.value());
    return {};
  }

  /// Reads straight runs, bounds and pins, and maps them to boundary places of the chart.
  Status readConstraints() {
    const DiskChart& chart = prepared_.chart;
    Result<StraightPlaces> straight = straightPlaces(chart, options_.straight);
    if (!straight.ok()) return straight.status();
    Result<BoundaryBounds> t = requestedBounds(chart, options_, straight.value());
    if (!t.ok()) return t.status();
    Result<IdVector<ChartId, std::vector<ChartPin>>> pins =
        pinsOfCharts(mesh_, prepared_.texcoords, options_.pins);
    if (!pins.ok()) return pins.status();
    straight_ = std::move(straight.value());
    bounds_ = std::move(t.value());
    pins_ = std::move(pins.value().front());
    connectivitySeconds_ = watch_.lap();
    return {};
  }

  Status layOut() {
    const Listener listener = listener_.part(kConnectivity, kSolved);
    if (!listener.at(Stage::Solve).tell()) return aborted();
    const DiskChart& chart = prepared_.chart;
    ThreadPool pool(usefulThreads(options_.threads, chart.triangleCount()));
    SolverOptions solver;
    solver.pool = &pool;
    solver.allowedBytes = allowedBytes(options_.memory);
    // Convergence is quadratic: most charts take 3 to 10 steps.
    constexpr double kUsualSteps = 6;
    const Listener ofSteps = listener.approach(kUsualSteps);
    ChartFlattener flattener(chart, solver, {false, bounds_, straight_}, ofSteps, choice_);
    const double setUp = watch_.lap();
    best_ = bestLayout(flattener, solver, ofSteps);
    if (best_.isCancelled() || listener_.isStopped()) return aborted();
    out_.report.timings = flattener.timings();
    out_.report.timings.solve += setUp;
    out_.report.timings.connectivity = connectivitySeconds_;
    out_.report.threads = pool.threads();
    out_.straight = straightVertices(chart, straight_);
    out_.bounds = vertexBounds(chart, bounds_);
    return listener_.part(Stage::Check, kSolved, 1).tell() ? Status() : aborted();
  }

  Attempt bestLayout(ChartFlattener& flattener, const SolverOptions& solver,
                     const Listener& listener) {
    const OutlineGoal goal = outlineGoal(options_, bounds_);
    const RefineConstraints refining{options_.balance,    bounds_,     pins_,
                                     solver.allowedBytes, solver.pool, listener};
    if (pins_.empty()) return flattenAndRefine(flattener, goal, {}, refining);
    Attempt out = flattenChart(flattener, goal);
    pin(flattener, pins_, {solver.allowedBytes, solver.pool}, out);
    refineChart(flattener, refining, out);
    if (out.isCancelled()) return out;
    const DiskChart& chart = prepared_.chart;
    const std::string missed = missedText(exceededBounds(chart, out.uv, bounds_, straight_),
                                          bentPlaces(chart, out.uv, straight_));
    if (!missed.empty()) out.fallbacks.push_back("pins: " + missed);
    return out;
  }

  void finish() {
    const DiskChart& chart = prepared_.chart;
    watch_.lap();
    out_.uv = inMeshUnit(chart, best_);
    const double largestT = *std::max_element(best_.t.begin(), best_.t.end());
    out_.report.charts.push_back(makeChartReport(chart, best_, largestT));
    out_.report.timings.check += watch_.lap();
    out_.report.input = std::move(prepared_.summary);
    out_.report.options = options_;
    out_.report.valid = out_.report.charts.front().valid;
    out_.vertexMap.assign(chart.inputVertex.begin(), chart.inputVertex.end());
    out_.triangles.assign(chart.vertexOfCorner.begin(), chart.vertexOfCorner.end());
    const auto& ofCorner = prepared_.texcoords.ofCorner;
    out_.cornerUv.assign(ofCorner.begin(), ofCorner.end());
  }

  const InputMesh mesh_;
  const FlattenOptions& options_;
  const Listener listener_;
  Stopwatch watch_;
  SolverChoice choice_;
  Prepared prepared_;
  StraightPlaces straight_;
  BoundaryBounds bounds_;
  std::vector<ChartPin> pins_;
  double connectivitySeconds_ = 0;
  Attempt best_;
  FlattenResult out_;
};

}  // namespace

Result<FlattenResult> flatten(const PolygonMesh& mesh, const FlattenOptions& options) {
  return guarded([&] { return Flattening(mesh, options).run(); });
}

Result<FlattenResult> flatten(const MeshView& mesh, const FlattenOptions& options) {
  return guarded([&] { return Flattening(mesh, options).run(); });
}

}  // namespace abflat
