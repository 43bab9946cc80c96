#include "refine_chart.h"

#include <algorithm>
#include <cmath>

#include "flatten_chart.h"
#include "refine/refine.h"

namespace abflat {
namespace {

/// From here on a bound allows every angle.
constexpr double kFree = 2;

/// Vertices that stay: pinned ones, and the boundary where it has to keep its angles.
std::vector<std::uint8_t> fixedVertices(const DiskChart& chart, const RefineWishes& wishes,
                                        bool keepsOutline) {
  std::vector<std::uint8_t> out;
  if (wishes.pins.empty() && !keepsOutline) return out;
  out.assign(chart.vertexCount(), 0);
  for (const ChartPin& pin : wishes.pins) out[pin.vertex] = 1;
  if (keepsOutline)
    for (const std::uint32_t h : chart.boundary) out[chart.vertexOfCorner[h]] = 1;
  return out;
}

double areaOf(const DiskChart& chart, const std::vector<double>& uv) {
  double sum = 0;
  for (const std::uint32_t h : chart.boundary) {
    const double* a = &uv[2 * std::size_t{chart.vertexOfCorner[h]}];
    const double* b = &uv[2 * std::size_t{chart.vertexOfCorner[nextCorner(h)]}];
    sum += (a[0] * b[1] - a[1] * b[0]) / 2;
  }
  return sum;
}

void scaleToArea(const DiskChart& chart, double area, std::vector<double>& uv) {
  const double scale = std::sqrt(area / areaOf(chart, uv));
  for (double& x : uv) x *= scale;
}

}  // namespace

void refineChart(ChartFlattener& flattener, const RefineWishes& wishes, Attempt& attempt) {
  if (!(wishes.balance > 0) || attempt.solution.cancelled) return;
  attempt.refined = RefineReport();
  if (!attempt.valid()) {
    attempt.refined->limit = "a layout that is not valid is not refined";
    return;
  }
  flattener.endSolving();  // so that one factor is held at a time
  const DiskChart& chart = flattener.chart();
  const bool isBounded =
      std::any_of(wishes.bounds.begin(), wishes.bounds.end(), [](double t) { return t < kFree; });
  const bool keepsOutline = isBounded || !flattener.straight().empty();
  RefineOptions options;
  options.balance = wishes.balance;
  options.isFixed = fixedVertices(chart, wishes, keepsOutline);
  options.allowedBytes = wishes.allowedBytes;
  options.pool = wishes.pool;
  options.onStep = wishes.onStep;
  Attempt refined = attempt;
  Refinement found = refine(chart, attempt.uv, options);
  if (options.isFixed.empty()) scaleToArea(chart, areaOf(chart, attempt.uv), found.uv);
  refined.uv = std::move(found.uv);
  flattener.measure(refined);
  RefineReport& report = *refined.refined;
  report.energyBefore = found.energyBefore;
  report.energy = found.energy;
  report.steps = found.steps;
  if (keepsOutline)
    report.limit = "the boundary stays where it is, so that it keeps its angles";
  else if (found.isHeldApart)
    report.limit = "parts of the boundary are held apart";
  if (const std::string note = withoutFactorNote(found.memory); !note.empty())
    refined.fallbacks.push_back("refining: " + note);
  if (refined.valid()) {
    attempt = std::move(refined);
    return;
  }
  report.limit = "what has less energy is not valid";
  report.energy = report.energyBefore;
  attempt.refined = report;
}

}  // namespace abflat
