#include "boundary/chart_flattener.h"

#include <cmath>
#include <cstdio>

#include "check/distortion.h"
#include "layout/layout.h"
#include "layout/tutte.h"
#include "solve/interior_point.h"
#include "stopwatch.h"

namespace abflat {
namespace {

/// Floors of the barrier to try one after another: each makes the smallest angles larger.
constexpr double kFloors[] = {kDefaultBarrierFloor, 1e-1, 1};

std::string withFloor(const char* text, double floor) {
  char out[200];
  std::snprintf(out, sizeof out, text, floor);
  return out;
}

}  // namespace

ChartFlattener::ChartFlattener(const DiskChart& chart, SolverOptions options,
                               std::function<void(const char*)> onStage, const KktOptions& linear)
    : chart_(chart),
      problem_(buildAngleProblem(chart)),
      solver_(problem_, std::move(options), linear),
      onStage_(onStage ? std::move(onStage) : [](const char*) {}) {}

Attempt ChartFlattener::attempt(const std::vector<double>& t, const Attempt* warm) {
  Attempt a;
  a.t = t;
  setBounds(problem_, chart_, t);
  Stopwatch watch;
  a.solution = solver_.solve(warm ? &warm->solution : nullptr);
  timings_.solve += watch.lap();
  if (a.solution.cancelled) return a;
  if (a.solution.barrierFloor > 0)
    a.fallbacks.push_back(
        withFloor("the active set stalled; interior point with a barrier floor of %g",
                  a.solution.barrierFloor));
  layOutAndCheck(a);
  for (const double floor : kFloors) {
    if (a.validity.flippedTriangles == 0 || floor <= a.solution.barrierFloor) continue;
    Attempt b = a;
    watch.lap();
    b.solution = solver_.solveWithFloor(floor);
    timings_.solve += watch.lap();
    if (b.solution.cancelled) return b;
    b.fallbacks.push_back(withFloor(
        "angles too small to be drawn; interior point with a barrier floor of %g", floor));
    layOutAndCheck(b);
    a = std::move(b);
  }
  return a;
}

Attempt ChartFlattener::tutte(const std::string& reason) {
  Stopwatch watch;
  Attempt a;
  a.t.assign(chart_.boundary.size(), 1);
  a.solver = "tutte";
  a.uv = embedTutte(chart_).uv;
  timings_.layout += watch.lap();
  a.solution.converged = true;
  a.validity = checkValidity(chart_, a.uv);
  a.angularDistortion = measureDistortion(chart_, a.uv).angular;
  timings_.check += watch.lap();
  a.fallbacks.push_back(reason + "; Tutte's embedding on a circle instead");
  return a;
}

void ChartFlattener::layOutAndCheck(Attempt& a) {
  Stopwatch watch;
  onStage_("layout");
  a.solver = a.solution.barrierFloor > 0 ? "interiorPoint" : "activeSet";
  a.uv = layOut(chart_, a.solution.angles);
  timings_.layout += watch.lap();
  onStage_("check");
  a.validity = checkValidity(chart_, a.uv);
  a.angularDistortion = measureDistortion(chart_, a.uv).angular;
  timings_.check += watch.lap();
}

}  // namespace abflat
