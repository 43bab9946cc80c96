#include "boundary/delaunay_step.h"

#include "boundary/auto_bounds.h"
#include "check/delaunay.h"

namespace abflat {
namespace {

/// Radians left to pi, tried in order: coordinates are rounded, and exactly on the limit rounding
/// would decide.
constexpr double kMargins[] = {1e-8, 1e-6, 1e-4};

std::vector<std::array<std::uint32_t, 2>> inputEdges(const DiskChart& chart,
                                                     const std::vector<ChartCorner>& halfEdges) {
  std::vector<std::array<std::uint32_t, 2>> out;
  out.reserve(halfEdges.size());
  for (const ChartCorner h : halfEdges)
    out.push_back({chart.inputVertex[chart.vertexOfCorner[h]],
                   chart.inputVertex[chart.vertexOfCorner[nextCorner(h)]]});
  return out;
}

/// Why a Delaunay layout is rejected; empty if it is not.
std::string objection(const Attempt& next, const Attempt& before) {
  if (!next.converged()) return "no layout with this connectivity was found";
  if (next.validity.flippedTriangles > 0) return "its angles are too small to draw";
  if (before.valid() && !next.valid())
    return "its boundary crosses itself; a smaller t, or t = auto, prevents that";
  return {};
}

}  // namespace

Attempt madeDelaunay(ChartFlattener& flattener, Attempt attempt, Untangle untangle) {
  const DiskChart& chart = flattener.chart();
  const DelaunayCheck before = checkDelaunay(chart, attempt.uv);
  DelaunayReport report;
  report.edges = before.edges;
  report.violated = report.violatedBefore = before.violated.size();
  report.angularDistortionBefore = attempt.distortion.angular;
  const auto keep = [&](const std::string& why) {
    if (!why.empty()) attempt.fallbacks.push_back("the layout is not Delaunay: " + why);
    attempt.delaunay = report;
    attempt.delaunayMargin = std::nullopt;
    return std::move(attempt);
  };
  if (before.violated.empty()) return keep({});
  if (attempt.solver == Solver::Tutte) return keep("there are no angles to start from");
  if (const std::string note = flattener.memoryNote(); !note.empty())
    return keep(note + ", and the Delaunay condition needs that factor");

  std::string why;
  for (const double margin : kMargins) {
    attempt.delaunayMargin = margin;
    Attempt next = untangled(flattener, flattener.attempt(attempt.t, &attempt), untangle);
    if (next.isCancelled()) return next;
    why = objection(next, attempt);
    if (!next.converged()) break;
    if (!why.empty()) continue;
    report.violated = checkDelaunay(chart, next.uv).violated.size();
    if (report.violated > 0) {
      why = std::to_string(report.violated) + " edges miss the limit by a rounding error";
      report.violated = report.violatedBefore;
      continue;
    }
    next.fallbacks.insert(next.fallbacks.begin(), attempt.fallbacks.begin(),
                          attempt.fallbacks.end());
    const std::vector<NewtonStep>& first = attempt.solution.history;
    next.solution.history.insert(next.solution.history.begin(), first.begin(), first.end());
    next.delaunay = report;
    return next;
  }
  report.resisting = inputEdges(chart, flattener.resistingEdges(attempt));
  return keep(why + "; " + std::to_string(report.resisting.size()) +
              " edges cannot become Delaunay");
}

}  // namespace abflat
