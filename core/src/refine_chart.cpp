#include "refine_chart.h"

#include <algorithm>

#include "layout/pose.h"
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

std::string limitOf(const Refinement& found, bool keepsOutline) {
  if (keepsOutline) return "the boundary keeps its form, so that it keeps its angles";
  if (!found.isConverged)
    return "Newton's method was ended after " + std::to_string(found.steps) + " steps";
  return found.isHeldApart ? "parts of the boundary are held apart" : "";
}

}  // namespace

void refineChart(ChartFlattener& flattener, const RefineWishes& wishes, Attempt& attempt) {
  if (!(wishes.balance > 0) || attempt.solution.cancelled) return;
  if (!attempt.valid()) {
    attempt.fallbacks.emplace_back("a layout that is not valid is not refined");
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
  options.mayScale = wishes.pins.empty();
  options.allowedBytes = wishes.allowedBytes;
  options.pool = wishes.pool;
  options.onStep = wishes.onStep;
  Refinement found = refine(chart, attempt.uv, options);
  if (options.mayScale) pose(chart, attempt.uv, found.uv);
  Attempt refined = attempt;
  refined.uv = std::move(found.uv);
  flattener.measure(refined);
  if (!refined.valid()) {
    attempt.refined = {found.energyBefore, found.energyBefore, found.steps,
                       "what has less energy is not valid"};
    return;
  }
  refined.refined = {found.energyBefore, found.energy, found.steps, limitOf(found, keepsOutline)};
  if (const std::string note = withoutFactorNote(found.memory); !note.empty())
    refined.fallbacks.push_back("refining: " + note);
  attempt = std::move(refined);
}

}  // namespace abflat
