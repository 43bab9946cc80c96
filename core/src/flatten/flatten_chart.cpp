#include "flatten/flatten_chart.h"

#include <algorithm>

#include "boundary/delaunay_step.h"
#include "check/delaunay.h"
#include "mesh/triangle_geometry.h"

namespace abflat {
namespace {

constexpr double kMegabyte = 1048576;
#ifdef __EMSCRIPTEN__
/// In MB. The mesh and the results need the rest of the 4 GB that 32 bits can address.
constexpr double kAutoMemoryMegabytes = 3072;
#else
constexpr double kAutoMemoryMegabytes = 1e9;
#endif

/// The angles of the solution, or those of the layout itself if there is no solution.
std::vector<double> flatAngles(const DiskChart& chart, const Attempt& attempt) {
  if (!attempt.solution.angles.empty()) return attempt.solution.angles;
  std::vector<double> positions, angles;
  for (std::size_t i = 0; i < attempt.uv.size(); i += 2)
    positions.insert(positions.end(), {attempt.uv[i], attempt.uv[i + 1], 0});
  for (const ChartTriangle f : chart.triangles()) {
    const TriangleVertices v = verticesOf(chart.vertexOfCorner, f);
    for (const double a : anglesOrMadeUp(positions, v, cornerAngles(positions, v)))
      angles.push_back(a);
  }
  return angles;
}

}  // namespace

std::uint64_t allowedBytes(double megabytes) {
  // Larger numbers would overflow, and such factors would not fit in memory either.
  constexpr double kMost = 1e12;
  const double allowed = megabytes == kAutoMemory ? kAutoMemoryMegabytes : megabytes;
  return static_cast<std::uint64_t>(std::min(allowed, kMost) * kMegabyte);
}

OutlineGoal automaticGoal(const BoundaryBounds& t) { return {t, true, Untangle::Best, false}; }

OutlineGoal outlineGoal(const FlattenOptionValues& options, const BoundaryBounds& t) {
  const bool isAuto = options.t == kAutoT;
  const Untangle usual = isAuto ? Untangle::Best : Untangle::None;
  return {t, isAuto, options.untangle == Untangle::Auto ? usual : options.untangle,
          options.delaunay};
}

Attempt flattenChart(ChartFlattener& flattener, const OutlineGoal& goal, const Effort& effort) {
  Attempt best =
      goal.isAuto ? flattenAutomatically(flattener, goal.t, goal.untangle, effort)
                  : untangled(flattener, flattener.attempt(goal.t, nullptr), goal.untangle, effort);
  if (!goal.isDelaunay || best.isCancelled()) return best;
  return madeDelaunay(flattener, std::move(best), goal.untangle);
}

void pin(ChartFlattener& flattener, const std::vector<ChartPin>& pins, const PinOptions& options,
         Attempt& attempt) {
  if (pins.empty() || attempt.isCancelled()) return;
  const DiskChart& chart = flattener.chart();
  std::vector<ChartPin> inUnits = pins;
  for (ChartPin& p : inUnits)
    for (double& x : p.uv) x /= chart.unit;
  flattener.endSolving();  // so that one factor is held at a time
  PinnedLayout layout = pinLayout({chart.vertexOfCorner, chart.boundary},
                                  flatAngles(chart, attempt), attempt.uv, inUnits, options);
  if (const std::string note = withoutFactorNote(layout.memory); !note.empty())
    attempt.fallbacks.push_back("pins: " + note);
  if (!layout.isSolved)
    attempt.fallbacks.push_back("the linear system that spreads the pins is numerically singular" +
                                std::string(layout.memory.fits() ? "" : ", or needs more memory") +
                                "; moved only the pinned vertices");
  attempt.wasValidUnpinned = attempt.valid();
  attempt.uv = std::move(layout.uv);
  attempt.pins = PinReport{pins.size(), layout.deviation * chart.unit};
  flattener.measure(attempt);
  if (attempt.delaunay)
    attempt.delaunay->violated = checkDelaunay(chart, attempt.uv).violated.size();
}

std::vector<double> inMeshUnit(const DiskChart& chart, Attempt& attempt) {
  std::vector<double> uv = attempt.uv;
  for (double& x : uv) x *= chart.unit;
  bool isExact = true;
  for (std::size_t i = 0; i < uv.size(); ++i)
    isExact = isExact && uv[i] / chart.unit == attempt.uv[i];
  if (isExact) return uv;
  for (std::size_t i = 0; i < uv.size(); ++i) attempt.uv[i] = uv[i] / chart.unit;
  attempt.validity = checkValidity(chart, attempt.uv);
  attempt.distortion = measureDistortion(chart, attempt.uv);
  return uv;
}

}  // namespace abflat
