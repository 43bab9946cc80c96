#include "unwrap_chart.h"

#include <algorithm>

#include "chart_report.h"

namespace abflat {

namespace {

/// What no report needs: several times the memory of the layout.
void dropUnknowns(Attempt& attempt) {
  attempt.t = {};
  attempt.uv = {};
  AngleSolution& s = attempt.solution;
  s.angles = {};
  s.multipliers = {};
  s.weight = {};
  s.active = {};
  s.activeEdge = {};
}

}  // namespace

FlatChart flattenOne(const DiskChart& chart, const UnwrapOptionValues& options,
                     const ChartWishes& wishes, ThreadPool& pool,
                     const std::function<bool()>& goesOn) {
  SolverOptions solver;
  solver.pool = &pool;
  solver.onStep = [&](int, const NewtonStep&) { return goesOn(); };
  solver.allowedBytes = allowedBytes(options.memory);
  ChartFlattener flattener(chart, solver);
  flattener.requireSeparation();
  flattener.requireStraight(wishes.straight);
  FlattenOptions wanted;
  wanted.t = options.t;
  // n angles that may be others than pi sum to (n - 2) pi: a chart with few of them cannot be as
  // convex as others.
  const auto n = static_cast<double>(placesThatTurn(chart, wishes.straight));
  const double t = options.t == kAutoT ? 2 : std::max(options.t, 1 - 2 / n);
  FlatChart out;
  out.attempt = flattenChart(flattener, std::vector<double>(chart.boundary.size(), t), wanted);
  if (out.attempt.solution.cancelled) return out;
  out.unpacked = inMeshUnit(chart, out.attempt);
  if (!wishes.pins.empty()) {
    pin(flattener, wishes.pins, {solver.allowedBytes, &pool}, out.attempt);
    out.uv = inMeshUnit(chart, out.attempt);
    out.isFixed = true;
  }
  if (out.attempt.straight) out.attempt.straight->released = wishes.released;
  out.problem = findProblem(chart, out.attempt);
  dropUnknowns(out.attempt);
  return out;
}

void checkInPlace(const DiskChart& chart, FlatChart& flat) {
  if (!flat.problem.empty()) return;
  flat.attempt.validity = checkValidity(chart, flat.uv);
  if (!flat.attempt.validity.valid())
    flat.problem = "valid by itself, but its smallest triangles are lost at the scale of the atlas";
}

}  // namespace abflat
