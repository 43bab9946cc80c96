#include "abflat/flatten.h"

#include <algorithm>
#include <cmath>

#include "abflat/io.h"
#include "boundary/auto_bounds.h"
#include "boundary/requested_bounds.h"
#include "chart/disk_chart.h"
#include "chart_report.h"
#include "mesh/surface.h"
#include "stopwatch.h"

namespace abflat {
namespace {

/// Progress of the solver over all attempts: convergence is quadratic and takes 3 to 10 steps on
/// most charts, so the bar slows down after that.
SolverOptions solverOptions(const FlattenOptions& options, int& steps) {
  SolverOptions out;
  if (!options.progress) return out;
  out.onStep = [&options, &steps](int, const NewtonStep& now) {
    const double solved = 1 - std::exp(-++steps / 5.0);
    return options.progress({"solve", steps, now.constraint, 0.05 + 0.8 * solved});
  };
  return out;
}

Attempt flattenChart(ChartFlattener& flattener, const std::vector<double>& t,
                     const FlattenOptions& options) {
  if (options.t == kAutoT)
    return flattenAutomatically(
        flattener, t, options.untangle == Untangle::Auto ? Untangle::Best : options.untangle);
  return untangled(flattener, flattener.attempt(t, nullptr), options.untangle);
}

std::vector<std::uint32_t> cornerToOutput(const PolygonMesh& mesh, const Surface& surface) {
  std::vector<std::uint32_t> out(mesh.faceVertices.size());
  for (std::size_t c = 0; c < surface.triangulation.corner.size(); ++c)
    out[surface.triangulation.corner[c]] = surface.fans.ofCorner[c];
  return out;
}

}  // namespace

Result<FlattenResult> flatten(const PolygonMesh& mesh, const FlattenOptions& options) {
  Stopwatch watch;
  const auto go = [&](const char* stage, double fraction) {
    return !options.progress || options.progress({stage, 0, 0, fraction});
  };
  const Status aborted{StatusCode::Aborted, "cancelled"};
  if (Status s = validateArrays(mesh); !s.ok()) return s;
  if (!go("connectivity", 0)) return aborted;

  const Surface surface = buildSurface(mesh);
  if (!surface.summary.disk.ok()) return surface.summary.disk;
  const DiskChart chart = makeDiskChart(mesh, surface);
  const Result<std::vector<double>> t = requestedBounds(chart, options);
  if (!t.ok()) return t.status;
  FlattenResult out;
  Timings& timings = out.report.timings;
  const double connectivity = watch.lap();

  if (!go("solve", 0.05)) return aborted;
  int steps = 0;
  ChartFlattener flattener(chart, solverOptions(options, steps));
  Attempt best = flattenChart(flattener, t.value, options);
  if (best.solution.cancelled) return aborted;
  timings = flattener.timings();
  timings.connectivity = connectivity;

  if (!go("check", 0.9)) return aborted;
  watch.lap();
  out.uv = std::move(best.uv);
  for (double& x : out.uv) x *= chart.unit;
  const double common = *std::max_element(best.t.begin(), best.t.end());
  out.report.charts.push_back(makeChartReport(chart, best, common, out.uv));
  timings.check += watch.lap();

  out.report.input = surface.summary;
  out.report.optionT = options.t;
  out.report.valid = out.report.charts.front().valid;
  out.vertexMap = chart.inputVertex;
  out.triangles = chart.vertexOfCorner;
  out.cornerUv = cornerToOutput(mesh, surface);
  return out;
}

}  // namespace abflat
