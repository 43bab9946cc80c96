#include "boundary/chart_flattener.h"

#include <algorithm>
#include <cmath>

#include "base/constants.h"
#include "base/number_text.h"
#include "base/stopwatch.h"
#include "boundary/contacts.h"
#include "layout/layout.h"
#include "layout/pose.h"
#include "layout/tutte.h"
#include "solve/angle_solver.h"
#include "solve/interior_point.h"

namespace abflat {
namespace {

/// Floors of the barrier, tried one after another: each makes the smallest angles larger.
constexpr double kFloors[] = {kDefaultBarrierFloor, 1e-1, 1};

/// Weights of the boundary in Tutte's embedding, tried one after another.
constexpr double kBoundaryWeights[] = {1, 0.1, 0.01, 1e-3};

/// Compliances for condition (9), tried in order: the smaller, the less an edge resists that could
/// give way.
constexpr double kCompliances[] = {1, 0.1, 1e-2, 1e-3};
/// Radians beyond pi, with the last compliance.
constexpr double kResisting = 1e-2;

std::string withFloor(const char* why, double floor) {
  return std::string(why) + "; used the interior point with a barrier floor of " +
         withDigits(floor, 6);
}

std::string heavierAngles(const AngleProblem& problem, const AngleSolution& solution) {
  std::size_t count = 0;
  for (const ChartCorner c : problem.corners()) count += solution.weight[c] != problem.weight[c];
  return std::to_string(count) + (count == 1 ? " angle got" : " angles got") +
         " more weight, to stay away from 0 and pi";
}

std::string reasonWithoutFactor(const FactorMemory& memory) {
  if (memory.fits()) return {};
  constexpr double kMegabyte = 1048576;
  const auto megabytes = [](std::uint64_t bytes) {
    return withDigits(static_cast<double>(bytes) / kMegabyte, 4) + " MB";
  };
  return "factoring the matrix needs " + megabytes(memory.needed) + ", but only " +
         megabytes(memory.allowed) + " are allowed";
}

/// Whether coordinates do not resolve the angles of the solution.
bool isMisdrawn(const Attempt& a) {
  return a.validity.flippedTriangles > 0 || (a.solution.converged && !a.hasAskedAngles());
}

}  // namespace

Validity checkSeparated(const DiskChart& chart, const std::vector<double>& uv) {
  Validity v = checkValidity(chart, uv);
  if (!v.valid()) return v;
  v.crossings = findContacts(chart, uv);
  return v;
}

std::string withoutFactorNote(const FactorMemory& memory) {
  if (memory.fits()) return {};
  return reasonWithoutFactor(memory) +
         (memory.fitsInSingle() ? "; used single precision and conjugate gradients instead"
                                : "; used conjugate gradients with multigrid instead");
}

ChartFlattener::ChartFlattener(const DiskChart& chart, SolverOptions options, LayoutDemands demands,
                               Listener listener, const SolverChoice& choice)
    : chart_(chart),
      demands_(std::move(demands)),
      problem_(buildAngleProblem(chart, options.pool)),
      solver_(std::make_unique<AngleSolver>(problem_, counting(std::move(options)), choice)),
      listener_(std::move(listener)) {}

ChartFlattener::~ChartFlattener() = default;

void ChartFlattener::endSolving() {
  if (!solver_) return;
  eliminationRank_ = solver_->eliminationRank();
  solver_.reset();
}

IdVector<ChartVertex, std::uint32_t> ChartFlattener::eliminationRank() const {
  return solver_ ? solver_->eliminationRank() : eliminationRank_;
}

SolverOptions ChartFlattener::counting(SolverOptions options) {
  options.onStep = [this](const NewtonStep& now) {
    ++steps_;
    return listener_.tellStep(steps_, now.constraint) && steps_ <= mostSteps_;
  };
  return options;
}

/// For an attempt ended by the caller, or by the limit on steps.
Attempt ChartFlattener::withoutLayout(const BoundaryBounds& t) const {
  Attempt out;
  out.ending = listener_.isStopped() ? Ending::Cancelled : Ending::GivenUp;
  out.t = t;
  return out;
}

double ChartFlattener::leastDistance(const std::vector<double>& uv) const {
  constexpr double kCells = 4;
  return kCells * contactCell(chart_, uv);
}

Crossings ChartFlattener::crossings(const std::vector<double>& uv) const {
  Crossings exact = findCrossings(boundaryUv(chart_, uv));
  return exact.count > 0 || !demands_.areSeparated ? exact : findContacts(chart_, uv);
}

Attempt ChartFlattener::attempt(const BoundaryBounds& t, const Attempt* warm, Exactness exactness) {
  Attempt a;
  a.t = t;
  if (warm) a.delaunayMargin = warm->delaunayMargin;
  const bool isDelaunay = warm && warm->delaunayMargin;
  setAllBounds(a.t, a.delaunayMargin);
  Stopwatch watch;
  a.solution =
      isDelaunay ? solver_->solveDelaunay(warm->solution)
                 : solver_->solve(warm ? &warm->solution : nullptr, exactness == Exactness::Rough);
  timings_.solve += watch.lap();
  if (a.solution.isEnded) return withoutLayout(t);
  if (std::string note = withoutFactorNote(solver_->memory()); !note.empty() && !isDelaunay)
    a.fallbacks.push_back(std::move(note));
  if (!a.solution.weight.empty()) a.fallbacks.push_back(heavierAngles(problem_, a.solution));
  if (a.solution.barrierFloor > 0)
    a.fallbacks.push_back(withFloor("the active set stalled", a.solution.barrierFloor));
  layOutAndCheck(a);
  for (const double floor : kFloors) {
    // Constraints that cannot be met are not met with a higher floor either.
    const bool isHopeless = a.solution.barrierFloor > 0 && !a.solution.converged;
    if (isDelaunay || isHopeless || !isMisdrawn(a) || floor <= a.solution.barrierFloor) continue;
    Attempt b = a;
    watch.lap();
    b.solution = solver_->solveWithFloor(floor);
    timings_.solve += watch.lap();
    if (b.solution.isEnded) return withoutLayout(t);
    b.fallbacks.push_back(withFloor("angles were too small to draw", floor));
    layOutAndCheck(b);
    a = std::move(b);
  }
  return a;
}

void ChartFlattener::setAllBounds(const BoundaryBounds& t, std::optional<double> delaunayMargin) {
  setBounds(problem_, chart_, t);
  setStraight(problem_, chart_, demands_.straight);
  setDelaunay(problem_, chart_, delaunayMargin);
}

std::string ChartFlattener::memoryNote() const { return reasonWithoutFactor(solver_->memory()); }

std::vector<ChartCorner> ChartFlattener::resistingEdges(const Attempt& from) {
  Stopwatch watch;
  setAllBounds(from.t, 0);
  AngleSolution best = from.solution;
  for (const double compliance : kCompliances) {
    problem_.edgeCompliance = compliance;
    AngleSolution s = solver_->solveDelaunay(best);
    if (s.isEnded) return {};
    if (!s.converged) break;
    best = std::move(s);
  }
  problem_.edgeCompliance = 0;
  timings_.solve += watch.lap();
  std::vector<ChartCorner> out;
  for (const ChartCorner h : chart_.corners()) {
    const ChartCorner twin = chart_.twin[h];
    if (!twin.exists() || twin < h) continue;
    const double sum = best.angles[prevCorner(h)] + best.angles[prevCorner(twin)];
    if (sum > kPi + kResisting) out.push_back(h);
  }
  return out;
}

Attempt ChartFlattener::tutte(const BoundaryBounds& t, const std::string& reason) {
  Stopwatch watch;
  Attempt a;
  a.t = t;
  for (double& x : a.t) x = std::min(x, 1.0);
  a.solver = Solver::Tutte;
  for (const double weight : kBoundaryWeights) {
    watch.lap();
    a.uv = embedTutte(chart_, demands_.straight, weight).uv;
    pose(chart_, {}, a.uv);
    timings_.layout += watch.lap();
    measure(a);
    if (a.validity.valid()) break;
  }
  a.fallbacks.push_back(reason + "; used Tutte's embedding on a circle instead");
  return a;
}

void ChartFlattener::layOutAndCheck(Attempt& a) {
  Stopwatch watch;
  listener_.at(Stage::Layout).tell();
  a.solver = a.solution.barrierFloor > 0 ? Solver::InteriorPoint : Solver::ActiveSet;
  a.uv = layOut(chart_, a.solution.angles);
  timings_.layout += watch.lap();
  measure(a);
}

void ChartFlattener::measure(Attempt& a) {
  Stopwatch watch;
  listener_.at(Stage::Check).tell();
  a.validity = check(a.uv);
  a.distortion = measureDistortion(chart_, a.uv);
  const StraightPlaces& straight = demands_.straight;
  if (!straight.empty()) a.straight = reportStraight(chart_, straight, a.uv);
  a.exceeded = a.pins ? MissedAngles() : exceededBounds(chart_, a.uv, demands_.bounds, straight);
  a.bent = a.pins ? MissedAngles() : bentPlaces(chart_, a.uv, straight);
  timings_.check += watch.lap();
}

Validity ChartFlattener::check(const std::vector<double>& uv) const {
  return demands_.areSeparated ? checkSeparated(chart_, uv) : checkValidity(chart_, uv);
}

}  // namespace abflat
