#include "unwrap/chart.h"

#include <algorithm>
#include <cmath>

#include "base/counted.h"
#include "base/point2.h"
#include "flatten/chart_report.h"
#include "flatten/planar.h"
#include "flatten/refine_chart.h"
#include "mesh/triangle_geometry.h"
#include "refine/refine.h"

namespace abflat {

namespace {

/// Keeps what reports need; unknowns and history take several times the memory of the layout.
void keepMeasures(const DiskChart& chart, const StraightPlaces& straight, Attempt& attempt,
                  FlatChart& out) {
  out.area = areaOf(chart);
  out.solver = attempt.solver;
  out.iterations = static_cast<int>(attempt.solution.history.size());
  out.distortion = ChartDistortion(attempt.distortion);
  if (attempt.fallbacks.empty() && !attempt.refined && !attempt.pins && !attempt.straight &&
      straight.empty())
    return;
  out.uncommon = std::make_unique<UncommonParts>();
  out.uncommon->fallbacks = std::move(attempt.fallbacks);
  out.uncommon->refined = std::move(attempt.refined);
  out.uncommon->pins = attempt.pins;
  out.uncommon->straight = attempt.straight;
  out.uncommon->straightPlaces = straight;
}

/// Whether slivers, which no measure of distortion counts, make the chart many times as long.
bool isDrawnOut(const DiskChart& chart, const std::vector<double>& uv) {
  constexpr double kMany = 10;
  double onSurface = 0, inUv = 0;
  for (const ChartCorner h : chart.boundary) {
    const ChartVertex a = chart.vertexOfCorner[h], b = chart.vertexOfCorner[nextCorner(h)];
    const Point2 p = pointAt(uv, a), q = pointAt(uv, b);
    onSurface += norm(edgeVector(chart.positions, a, b));
    inUv += norm(q[0] - p[0], q[1] - p[1]);
  }
  return inUv > kMany * onSurface;
}

void describe(const DiskChart& chart, const ChartConstraints& constraints, Attempt& attempt,
              FlatChart& out) {
  if (attempt.straight) attempt.straight->released = constraints.released;
  out.problem = findProblem(chart, attempt);
  keepMeasures(chart, constraints.straight, attempt, out);
  out.isDrawnOut = isDrawnOut(chart, inChartUnit(chart, out.unpacked));
}

FlatChart projectedChart(const DiskChart& chart, Attempt& attempt) {
  FlatChart out;
  out.unpacked = inMeshUnit(chart, attempt);
  describe(chart, {}, attempt, out);
  return out;
}

bool isAnyStraight(const ChartConstraints& constraints) {
  return std::find(constraints.straight.begin(), constraints.straight.end(), 1) !=
         constraints.straight.end();
}

/// The same constraints without straight places.
ChartConstraints released(const DiskChart& chart, ChartConstraints constraints) {
  constraints.released += chart.boundary.size() - placesThatTurn(chart, constraints.straight);
  constraints.straight.assign(chart.boundary.size(), 0);
  return constraints;
}

/// Steps are cheap on a small chart, and saving a seam is worth many of them.
Effort effortFor(Patience patience, const DiskChart& chart, const UnwrapOptionValues& options) {
  constexpr int kFewest = 60, kMost = 200, kTriangles = 80000;
  if (patience != Patience::Little) {
    Effort out{8, 40};
    out.mayStayInvalid = patience == Patience::Much;
    return out;
  }
  const int steps = kTriangles / static_cast<int>(std::max(chart.triangleCount(), 1u));
  return {20, std::clamp(steps, kFewest, kMost),
          stretchBeforeRefining(options.maxStretch, Energy(options.balance)), true};
}

}  // namespace

FlatChart flattenOne(const DiskChart& chart, const UnwrapOptionValues& options,
                     const ChartConstraints& constraints, Patience patience, ThreadPool& pool,
                     const Listener& listener) {
  if (options.t == kAutoT && constraints.pins.empty() && constraints.straight.empty())
    if (std::optional<Attempt> attempt = projectPlanar(chart))
      return projectedChart(chart, *attempt);
  SolverOptions solver;
  solver.pool = &pool;
  solver.allowedBytes = allowedBytes(options.memory);
  // The n angles that may differ from pi sum to (n - 2) pi, so a chart with few of them cannot be
  // as convex as others.
  const auto n = static_cast<double>(placesThatTurn(chart, constraints.straight));
  const double t = options.t == kAutoT ? 2 : std::max(options.t, 1 - 2 / n);
  const BoundaryBounds bounds(chart.boundary.size(), t);
  ChartFlattener flattener(chart, solver, {true, bounds, constraints.straight}, listener);
  const OutlineGoal goal = options.t == kAutoT ? automaticGoal(bounds) : OutlineGoal{bounds};
  RefineConstraints refining{options.balance, bounds, {}, solver.allowedBytes, &pool, listener};
  refining.mayBeRough = true;
  const Effort effort = effortFor(patience, chart, options);
  const bool isPinned = !constraints.pins.empty();
  Attempt attempt = isPinned ? flattenChart(flattener, goal, effort)
                             : flattenAndRefine(flattener, goal, effort, refining);
  if (attempt.isCancelled()) return {};
  FlatChart out;
  if (isPinned) {
    Attempt alone = attempt;
    refineChart(flattener, refining, alone);
    // Pins are places in the atlas, where lengths along v may count more than those along u.
    const double aspect = options.resolution.aspect();
    refining.pins = constraints.pins;
    for (ChartPin& pinned : refining.pins) pinned.uv[1] /= aspect;
    pin(flattener, refining.pins, {solver.allowedBytes, &pool}, attempt);
    refineChart(flattener, refining, attempt);
    out.uv = inMeshUnit(chart, attempt);
    for (std::size_t i = 1; i < out.uv.size(); i += 2) out.uv[i] *= aspect;
    for (const ChartPin& pinned : constraints.pins) setPoint(out.uv, pinned.vertex, pinned.uv);
    out.unpacked = inMeshUnit(chart, alone);
    out.isFixed = true;
  } else {
    out.unpacked = inMeshUnit(chart, attempt);
  }
  describe(chart, constraints, attempt, out);
  out.patience = patience;
  if (out.problem.empty() || isPinned || !isAnyStraight(constraints)) return out;
  FlatChart free =
      flattenOne(chart, options, released(chart, constraints), patience, pool, listener);
  if (free.problem.empty()) return free;
  return out;
}

std::vector<double> inChartUnit(const DiskChart& chart, std::vector<double> uv) {
  for (double& x : uv) x /= chart.unit;
  return uv;
}

bool scaleToSurface(const DiskChart& chart, std::vector<double>& uv) {
  double twice = 0;
  for (const ChartTriangle f : chart.surfaceTriangles()) {
    const auto [a, b, c] = pointsOf(uv, verticesOf(chart.vertexOfCorner, f));
    twice += (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  }
  const double factor = std::sqrt(2 * areaOf(chart) / twice);
  if (!std::isfinite(factor)) return false;
  for (double& x : uv) x *= factor;
  return true;
}

double areaOf(const DiskChart& chart) { return surfaceArea(chart) * chart.unit * chart.unit; }

void checkInPlace(const DiskChart& chart, FlatChart& flat) {
  if (!flat.problem.empty()) return;
  const Validity v = checkValidity(chart, flat.uv);
  if (v.flippedTriangles > 0)
    flat.problem = "valid on its own, but rounded at the scale of the atlas, " +
                   counted(v.flippedTriangles, "triangle vanishes", "triangles vanish") +
                   ". Unwrap small parts on their own";
  else if (v.crossings.count > 0)
    flat.problem =
        "valid on its own, but rounded at the scale of the atlas, its outline touches itself at " +
        counted(v.crossings.count, "place", "places") + ". Cut it there";
}

}  // namespace abflat
