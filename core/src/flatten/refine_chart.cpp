#include "flatten/refine_chart.h"

#include <algorithm>
#include <optional>

#include "base/constants.h"
#include "base/stopwatch.h"
#include "boundary/move_apart.h"
#include "flatten/flatten_chart.h"
#include "layout/pose.h"
#include "refine/refine.h"

namespace abflat {
namespace {

/// From here on, in units of pi, a bound allows every angle.
constexpr double kFree = 2;

/// Vertices that must not move: pinned ones, and the boundary if it has to keep its angles.
IdVector<ChartVertex, std::uint8_t> fixedVertices(const DiskChart& chart,
                                                  const RefineConstraints& constraints,
                                                  bool keepsOutline) {
  IdVector<ChartVertex, std::uint8_t> out;
  if (constraints.pins.empty() && !keepsOutline) return out;
  out.assign(chart.vertexCount(), 0);
  for (const ChartPin& pin : constraints.pins) out[pin.vertex] = 1;
  if (keepsOutline)
    for (const ChartCorner h : chart.boundary) out[chart.vertexOfCorner[h]] = 1;
  return out;
}

bool isBounded(const RefineConstraints& constraints) {
  return std::any_of(constraints.bounds.begin(), constraints.bounds.end(),
                     [](double t) { return t < kFree; });
}

/// How the outline is constrained.
enum class Outline : std::uint8_t { Free, Shaped, Fixed };

/// A step solves several systems if the outline is held, so large charts take fewer of them.
int solvesFor(const DiskChart& chart, Outline outline) {
  constexpr double kTriangles = 4e6;
  const bool isShaped = outline == Outline::Shaped;
  const double fewest = isShaped ? 12 : 100, most = isShaped ? 200 : 600;
  return static_cast<int>(std::clamp(kTriangles / chart.triangleCount(), fewest, most));
}

RefineOptions optionsFor(const ChartFlattener& flattener, const RefineConstraints& constraints,
                         Outline outline) {
  RefineOptions out;
  out.energy = Energy(constraints.balance);
  out.isFixed = fixedVertices(flattener.chart(), constraints, outline == Outline::Fixed);
  out.maxSolves = solvesFor(flattener.chart(), outline);
  // Far below any bound on stretch; a step of a large chart takes a second.
  constexpr double kUnseen = 1e-4, kHardlySeen = 3e-4;
  constexpr std::uint32_t kLarge = 20'000;
  if (constraints.mayBeRough)
    out.leastHeld = flattener.chart().triangleCount() > kLarge ? kHardlySeen : kUnseen;
  out.eliminationRank = flattener.eliminationRank();
  out.allowedBytes = constraints.allowedBytes;
  out.pool = constraints.pool;
  out.listener = constraints.listener.at(Stage::Refine);
  return out;
}

std::string limitOf(const Refinement& found) {
  if (!found.isConverged)
    return "Newton's method stopped after " + std::to_string(found.steps) + " steps";
  return found.isHeldApart ? "parts of the boundary are held apart" : "";
}

/// Why an outline stopped once its form had settled.
std::string limitOf(const OutlineRules& rules, const DiskChart& chart,
                    const std::vector<double>& uv) {
  BoundaryBounds nearly = rules.bounds;
  for (double& t : nearly)
    if (t < kFree) t -= rules.margin / kPi;
  if (exceededBounds(chart, uv, nearly, rules.straight).count > 0)
    return "boundary angles reach their bounds";
  return rules.straight.empty() ? "" : "straight parts of the boundary stay straight";
}

/// Pulls parts that are nearly flat together again, as flattening does.
Attempt movedBack(ChartFlattener& flattener, const Attempt& touching) {
  Attempt out = movedApart(flattener, touching);
  for (std::size_t i = touching.fallbacks.size(); i < out.fallbacks.size(); ++i)
    out.fallbacks[i].insert(0, "refining: ");
  return out;
}

/// The attempt with its layout refined, checked and measured again, whether valid or not.
Attempt refined(ChartFlattener& flattener, const RefineOptions& options, const Attempt& attempt,
                bool isPinned = false) {
  const DiskChart& chart = flattener.chart();
  Refinement found = refine(chart, attempt.uv, options);
  if (!isPinned) pose(chart, attempt.uv, found.uv);
  Attempt out = attempt;
  out.uv = std::move(found.uv);
  flattener.measure(out);
  if (isTangled(out) && !isPinned) {
    out = movedBack(flattener, out);
    found.energy = energyOf(chart, out.uv, options.energy);
  }
  out.refined = {found.energyBefore, found.energy, found.steps, limitOf(found)};
  if (const std::string note = withoutFactorNote(found.memory); !note.empty())
    out.fallbacks.push_back("refining: " + note);
  return out;
}

/// Lowers the bounds (in units of pi) that are below 2. All angles sum to (n - 2) pi; `by` is
/// chosen so that the outline keeps part of its freedom.
BoundaryBounds lowered(BoundaryBounds t, const StraightPlaces& straight, double& by) {
  constexpr double kMost = 5e-3, kPart = 6;
  double room = 2, count = 0;
  const auto isHeld = [&](BoundaryIndex i) { return !straight.empty() && straight[i] != 0; };
  for (const BoundaryIndex i : t.ids()) {
    if (isHeld(i)) continue;
    room += t[i] - 1;
    count += t[i] < kFree;
  }
  by = count > 0 ? std::min(kMost, room / (kPart * count)) : 0;
  for (const BoundaryIndex i : t.ids())
    if (!isHeld(i) && t[i] < kFree) t[i] -= by;
  return t;
}

/// Refines with an outline that stays straight where asked and within its bounds, but may change
/// its form. Starts some way inside the bounds. Returns nothing if that gains nothing.
std::optional<Attempt> reshaped(ChartFlattener& flattener, const RefineConstraints& constraints,
                                const Attempt& attempt) {
  constexpr double kLeast = 1e-6;
  constexpr int kSteps = 40;
  if (!constraints.pins.empty() || attempt.solver == Solver::Tutte) return std::nullopt;
  const DiskChart& chart = flattener.chart();
  OutlineRules rules{flattener.straight(), {}, 0};
  Attempt start = attempt;
  double by = 0;
  if (isBounded(constraints)) {
    rules.bounds = constraints.bounds;
    const BoundaryBounds t = lowered(constraints.bounds, flattener.straight(), by);
    if (!(by > kLeast)) return std::nullopt;
    rules.margin = by * kPi;
    BoundaryBounds both = attempt.t;
    for (const BoundaryIndex i : both.ids()) both[i] = std::min(both[i], t[i]);
    start = flattener.attempt(both, &attempt);
    if (!start.valid() || exceededBounds(chart, start.uv, t, flattener.straight()).count > 0)
      return std::nullopt;
    pose(chart, attempt.uv, start.uv);
    std::vector<std::string> notes = attempt.fallbacks;
    for (const std::string& note : start.fallbacks)
      if (std::find(notes.begin(), notes.end(), note) == notes.end())
        notes.push_back("refining: " + note);
    start.fallbacks = std::move(notes);
  }
  flattener.endSolving();  // so that one factor is held at a time
  RefineOptions options = optionsFor(flattener, constraints, Outline::Shaped);
  options.maxSteps = kSteps;
  options.outline = std::move(rules);
  const double before = energyOf(chart, attempt.uv, options.energy);
  start = refined(flattener, options, start);
  if (!start.valid() || !(start.refined->energy < before)) return std::nullopt;
  Attempt out = attempt;
  out.uv = std::move(start.uv);
  out.fallbacks = std::move(start.fallbacks);
  flattener.measure(out);
  out.refined = start.refined;
  out.refined->energyBefore = before;
  if (out.refined->limit.empty()) out.refined->limit = limitOf(options.outline, chart, out.uv);
  return out;
}

/// An outline held by bounds nearly everywhere may do worse than the one it already has.
bool isWellShaped(const RefineReport& report) {
  constexpr double kWorthwhile = 0.5;
  return report.energy - Energy::kAtRest < kWorthwhile * (report.energyBefore - Energy::kAtRest);
}

/// Measures the time spent refining, without the checks.
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

Attempt flattenAndRefine(ChartFlattener& flattener, const OutlineGoal& goal, const Effort& effort,
                         const RefineConstraints& constraints) {
  const bool isFree = goal.isAuto && !isBounded(constraints) && flattener.straight().empty() &&
                      constraints.pins.empty();
  if (!(constraints.balance > 0) || !isFree) {
    Attempt out = flattenChart(flattener, goal, effort);
    refineChart(flattener, constraints, out);
    return out;
  }
  Attempt first = flattener.attempt(
      goal.t, nullptr, constraints.mayBeRough ? Exactness::Rough : Exactness::Converged);
  if (isTangled(first)) {
    const RefiningTime time(flattener);
    Attempt out = refined(flattener, optionsFor(flattener, constraints, Outline::Free), first);
    if (out.valid()) return out;
  }
  // Where needles need more digits than a rough solution has, refining cannot bring them back.
  constexpr double kSuspicious = 2;
  const bool isGood = first.valid() && first.distortion.symmetricDirichlet < kSuspicious;
  // Where even a rough solution was not found, no exact one is.
  if (constraints.mayBeRough && !isGood && first.converged())
    first = flattener.attempt(goal.t, &first);
  Attempt out = madeValid(flattener, std::move(first), goal.t, goal.untangle, effort);
  refineChart(flattener, constraints, out);
  return out;
}

void refineChart(ChartFlattener& flattener, const RefineConstraints& constraints,
                 Attempt& attempt) {
  if (!(constraints.balance > 0) || attempt.isCancelled()) return;
  // In some meshes most charts are single triangles, or flat.
  constexpr double kRounding = 1e-9;
  if (attempt.distortion.symmetricDirichlet <= 1 + kRounding && attempt.valid()) return;
  if (!attempt.valid()) {
    attempt.fallbacks.emplace_back("skipped refining, because the layout is not valid");
    return;
  }
  const RefiningTime time(flattener);
  const bool isFree = !isBounded(constraints) && flattener.straight().empty();
  std::optional<Attempt> shaped;
  if (!isFree) shaped = reshaped(flattener, constraints, attempt);
  if (shaped && isWellShaped(*shaped->refined)) {
    attempt = std::move(*shaped);
    return;
  }
  flattener.endSolving();  // so that one factor is held at a time
  Attempt out = refined(flattener,
                        optionsFor(flattener, constraints, isFree ? Outline::Free : Outline::Fixed),
                        attempt, !constraints.pins.empty());
  if (!isFree) out.refined->limit = "the boundary keeps its shape to keep its angles";
  if (shaped && !(out.valid() && out.refined->energy < shaped->refined->energy))
    out = std::move(*shaped);
  if (out.valid()) {
    attempt = std::move(out);
    return;
  }
  attempt.refined = {out.refined->energyBefore, out.refined->energyBefore, out.refined->steps,
                     "layouts with less energy are not valid"};
}

}  // namespace abflat
