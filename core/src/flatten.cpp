#include "abflat/flatten.h"

#include <chrono>
#include <cmath>
#include <cstdio>

#include "abflat/io.h"
#include "angle/angle_problem.h"
#include "chart/disk_chart.h"
#include "check/distortion.h"
#include "check/validity.h"
#include "layout/layout.h"
#include "mesh/surface.h"
#include "solve/active_set.h"

namespace abflat {
namespace {

/// Seconds since the last call, or since construction.
class Stopwatch {
 public:
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    const std::chrono::duration<double> passed = now - last_;
    last_ = now;
    return passed.count();
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

/// Angle sums of a disk's boundary: the n vertices share (n - 2) pi at least, since no interior
/// vertex can take more than 2 pi.
Status checkBound(double t, std::size_t boundaryVertices) {
  const double least = 1 - 2 / static_cast<double>(boundaryVertices);
  if (t >= least) return {};
  char text[160];
  std::snprintf(text, sizeof text,
                "t = %g cannot be met: with %zu boundary vertices the least possible t is %.17g", t,
                boundaryVertices, least);
  return {StatusCode::InfeasibleBound, text};
}

ActiveSetOptions solverOptions(const FlattenOptions& options) {
  ActiveSetOptions out;
  if (!options.progress) return out;
  out.onStep = [&options](int step, const NewtonStep& now) {
    // Convergence is quadratic and takes 3 to 10 steps on most charts: the bar slows down after
    // that.
    const double solved = 1 - std::exp(-step / 4.0);
    return options.progress({"solve", step, now.constraint, 0.05 + 0.75 * solved});
  };
  return out;
}

ChartReport makeChartReport(const DiskChart& chart, double t, const AngleSolution& solution,
                            const Validity& validity, const Distortion& d) {
  ChartReport r;
  r.faces = chart.triangleCount();
  r.boundaryVertices = chart.boundary.size();
  r.t = t;
  r.solver = "activeSet";
  r.linearSolver = "schur";
  r.iterations = static_cast<int>(solution.history.size());
  r.history = solution.history;
  r.constraintResidual = solution.constraintResidual;
  r.converged = solution.converged;
  r.angularDistortion = d.angular;
  r.lengthDistortion = d.length;
  r.quasiConformalMean = d.quasiConformalMean;
  r.quasiConformalMax = d.quasiConformalMax;
  r.stretchL2 = d.stretchL2;
  r.stretchLinf = d.stretchLinf;
  r.symmetricDirichlet = d.symmetricDirichlet;
  r.areaDistortionMin = d.areaMin;
  r.areaDistortionMax = d.areaMax;
  r.degenerateTriangles = validity.degenerateTriangles;
  r.flippedTriangles = validity.flippedTriangles;
  r.boundaryCrossings = validity.crossings.count;
  r.maxBoundaryAngle = validity.maxBoundaryAngle;
  r.valid = validity.valid() && solution.converged;
  return r;
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
  if (!(options.t > 0) || !std::isfinite(options.t))
    return Status{StatusCode::InvalidOption, "t must be a number above 0"};
  if (Status s = validateArrays(mesh); !s.ok()) return s;
  if (!go("connectivity", 0)) return aborted;

  const Surface surface = buildSurface(mesh);
  if (!surface.summary.disk.ok()) return surface.summary.disk;
  if (Status s = checkBound(options.t, surface.boundaryLoops.front().size()); !s.ok()) return s;
  const DiskChart chart = makeDiskChart(mesh, surface);
  FlattenResult out;
  Timings& timings = out.report.timings;
  timings.connectivity = watch.lap();

  if (!go("solve", 0.05)) return aborted;
  const AngleSolution solution =
      solveActiveSet(buildAngleProblem(chart, options.t), solverOptions(options));
  if (solution.cancelled) return aborted;
  timings.solve = watch.lap();

  if (!go("layout", 0.85)) return aborted;
  out.uv = layOut(chart, solution.angles);
  for (double& x : out.uv) x *= chart.unit;
  timings.layout = watch.lap();

  if (!go("check", 0.92)) return aborted;
  const Validity validity = checkValidity(chart, out.uv);
  out.report.charts.push_back(
      makeChartReport(chart, options.t, solution, validity, measureDistortion(chart, out.uv)));
  timings.check = watch.lap();

  out.report.input = surface.summary;
  out.report.optionT = options.t;
  out.report.valid = out.report.charts.front().valid;
  out.vertexMap = chart.inputVertex;
  out.triangles = chart.vertexOfCorner;
  out.cornerUv = cornerToOutput(mesh, surface);
  return out;
}

}  // namespace abflat
