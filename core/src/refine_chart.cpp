#include "refine_chart.h"

#include <algorithm>

#include "flatten_chart.h"
#include "layout/pose.h"
#include "refine/refine.h"
#include "stopwatch.h"

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

RefineOptions optionsFor(const DiskChart& chart, const RefineWishes& wishes, bool keepsOutline) {
  RefineOptions out;
  out.balance = wishes.balance;
  out.isFixed = fixedVertices(chart, wishes, keepsOutline);
  out.mayScale = wishes.pins.empty();
  out.allowedBytes = wishes.allowedBytes;
  out.pool = wishes.pool;
  out.onStep = wishes.onStep;
  return out;
}

bool isBounded(const RefineWishes& wishes) {
  return std::any_of(wishes.bounds.begin(), wishes.bounds.end(),
                     [](double t) { return t < kFree; });
}

/// The attempt's layout refined, checked and measured anew, valid or not.
Attempt refined(ChartFlattener& flattener, const RefineWishes& wishes, const Attempt& attempt) {
  const DiskChart& chart = flattener.chart();
  const bool keepsOutline = isBounded(wishes) || !flattener.straight().empty();
  RefineOptions options = optionsFor(chart, wishes, keepsOutline);
  options.place = flattener.place();
  Refinement found = refine(chart, attempt.uv, options);
  if (options.mayScale) pose(chart, attempt.uv, found.uv);
  Attempt out = attempt;
  out.uv = std::move(found.uv);
  flattener.measure(out);
  out.refined = {found.energyBefore, found.energy, found.steps, limitOf(found, keepsOutline)};
  if (const std::string note = withoutFactorNote(found.memory); !note.empty())
    out.fallbacks.push_back("refining: " + note);
  return out;
}

/// Counts what passes as refining, checks aside.
class RefiningTime {
 public:
  explicit RefiningTime(ChartFlattener& flattener)
      : flattener_(flattener), before_(flattener.timings().check) {}
  ~RefiningTime() { flattener_.addRefining(watch_.lap() - (flattener_.timings().check - before_)); }
  RefiningTime(const RefiningTime&) = delete;
  RefiningTime& operator=(const RefiningTime&) = delete;

 private:
  ChartFlattener& flattener_;
  double before_;
  Stopwatch watch_;
};

}  // namespace

Attempt flattenAndRefine(ChartFlattener& flattener, const std::vector<double>& t,
                         const FlattenOptions& options, const Effort& effort,
                         const RefineWishes& wishes) {
  const bool isFree = options.t == kAutoT && !isBounded(wishes) && flattener.straight().empty() &&
                      wishes.pins.empty();
  if (!(wishes.balance > 0) || !isFree) {
    Attempt out = flattenChart(flattener, t, options, effort);
    refineChart(flattener, wishes, out);
    return out;
  }
  Attempt first = flattener.attempt(t, nullptr);
  if (isTangled(first)) {
    const RefiningTime time(flattener);
    Attempt out = refined(flattener, wishes, first);
    if (out.valid()) return out;
  }
  Attempt out = madeValid(flattener, std::move(first), t, untangleOf(options), effort);
  refineChart(flattener, wishes, out);
  return out;
}

void refineChart(ChartFlattener& flattener, const RefineWishes& wishes, Attempt& attempt) {
  if (!(wishes.balance > 0) || attempt.solution.cancelled) return;
  // Most charts of some meshes are a triangle, or flat.
  constexpr double kRounding = 1e-9;
  if (attempt.distortion.symmetricDirichlet <= 1 + kRounding && attempt.valid()) return;
  if (!attempt.valid()) {
    attempt.fallbacks.emplace_back("a layout that is not valid is not refined");
    return;
  }
  flattener.endSolving();  // so that one factor is held at a time
  const RefiningTime time(flattener);
  Attempt out = refined(flattener, wishes, attempt);
  if (out.valid()) {
    attempt = std::move(out);
    return;
  }
  attempt.refined = {out.refined->energyBefore, out.refined->energyBefore, out.refined->steps,
                     "what has less energy is not valid"};
}

}  // namespace abflat
