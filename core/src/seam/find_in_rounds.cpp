#include "seam/find_in_rounds.h"

#include <functional>
#include <utility>

#include "base/stopwatch.h"
#include "seam/begin_search.h"
#include "seam/components_with_seams.h"
#include "seam/cut_in_rounds.h"
#include "seam/fair_seams.h"
#include "seam/make_symmetric.h"
#include "seam/merge_charts.h"
#include "seam/pockets.h"
#include "seam/prediction.h"
#include "seam/shorten_seams.h"

namespace abflat {
namespace {

/// Does one step on what has seams.
void improve(const SeamMesh& mesh, const SeamOptions& options, JoinedSeams& joined,
             const std::function<void(const SeamWork&)>& step) {
  if (!joined.part) {
    step(SeamWork{mesh, joined.given, options, *joined.solver, joined.scale, joined.seams});
    return;
  }
  const SeamPart& part = *joined.part;
  if (part.mesh.triangleCount() == 0) return;
  const Seams given = part.ofCorners(joined.given);
  Seams seams = part.ofCorners(joined.seams);
  LogScales scale = part.ofVertices(joined.scale);
  step(SeamWork{part.mesh, given, options, *joined.solver, scale, seams, mesh.totalArea()});
  part.putInto(joined.seams, seams);
  part.putInto(joined.scale, scale);
}

std::uint32_t chartsOnSurface(const SeamMesh& mesh, const CutSurface& s) {
  std::uint32_t count = 0;
  for (const CutSurface::Chart& chart : s.charts) count += !mesh.isFilling(chart.firstTriangle);
  return count;
}

}  // namespace

JoinedSeams findJoined(const SeamMesh& mesh, Seams given, const SeamOptions& options) {
  JoinedSeams out;
  Stopwatch watch;
  auto solver = std::make_unique<LogScale>(mesh, options.pool, options.eliminationRanks);
  const double analysisSeconds = watch.lap();
  out.given = std::move(given);
  out.ranks = solver->eliminationRanks();
  out.doubled = doubledEdges(mesh);
  const BegunSearch begun = beginSearch(mesh, out.given, options, out.doubled, *solver);
  CutInRounds cut = cutInRounds(mesh, begun, options, std::move(solver), out.ranks);
  out.seams = std::move(cut.seams);
  out.scale = std::move(cut.scale);
  out.solver = std::move(cut.solver);
  out.steps = cut.steps;
  out.steps.analysisSeconds += analysisSeconds;
  out.steps.handleLoops = begun.cut.handleLoops;
  out.steps.handleLength = begun.cut.length;
  watch.lap();
  if (!options.isAuto || !options.listener.tell()) return out;
  // A mirror is that of the whole.
  if (!options.mirror) out.part = componentsWithSeams(mesh, out.seams, options.listener);
  if (out.part)
    out.solver =
        std::make_unique<LogScale>(out.part->mesh, options.pool, out.part->ofVertices(out.ranks));
  else if (!out.solver)
    out.solver = std::make_unique<LogScale>(mesh, options.pool, out.ranks);
  out.steps.analysisSeconds += watch.lap();
  improve(mesh, options, out, [&](const SeamWork& work) {
    // Slits and splits are added one by one where needed; together they may be more than needed.
    out.steps.merges = mergeCharts(work);
    makeSymmetric(work);
  });
  out.steps.mergeSeconds = watch.lap();
  return out;
}

Seams finishJoined(const SeamMesh& mesh, JoinedSeams joined, const SeamOptions& options,
                   SeamReport& report) {
  Stopwatch watch;
  Seams& seams = joined.seams;
  const auto goesOn = [&] { return options.isAuto && options.listener.tell(); };
  bool isSolved = false;
  improve(mesh, options, joined, [&](const SeamWork& work) {
    const bool isFair = goesOn() && fairSeams(work);
    isSolved = isFair && !makeSymmetric(work);
  });
  Seams found = seams;
  LogScales foundScale = joined.scale;
  improve(mesh, options, joined, [&](const SeamWork& work) {
    if (goesOn()) shortenSeams(work, isSolved);
    if (goesOn()) makeSymmetric(work);
  });
  openPockets(mesh, joined.doubled, seams, options.listener);
  for (const SurfaceCorner h : seams.ids())
    if (seams[h]) found[h] = 1;
  const double seconds = watch.lap();
  const CutSurface s = cutAlong(mesh, seams, options.listener);
  static_cast<SeamSteps&>(report) = joined.steps;
  report.mergeSeconds += seconds;
  report.charts = chartsOnSurface(mesh, s);
  report.stretch = predictStretch(mesh, s, joined.scale).total;
  report.eliminationRanks = std::move(joined.ranks);
  report.found = std::move(found);
  report.foundScale = std::move(foundScale);
  report.scale = std::move(joined.scale);
  return std::move(joined.seams);
}

Seams findInRounds(const SeamMesh& mesh, Seams given, const SeamOptions& options,
                   SeamReport& report) {
  JoinedSeams joined = findJoined(mesh, std::move(given), options);
  return finishJoined(mesh, std::move(joined), options, report);
}

}  // namespace abflat
