#include "seam/find_in_rounds.h"

#include <utility>

#include "base/stopwatch.h"
#include "seam/begin_search.h"
#include "seam/cut_in_rounds.h"
#include "seam/fair_seams.h"
#include "seam/make_symmetric.h"
#include "seam/merge_charts.h"
#include "seam/pockets.h"
#include "seam/prediction.h"
#include "seam/shorten_seams.h"

namespace abflat {
namespace {

SeamWork workOn(const SeamMesh& mesh, const SeamOptions& options, JoinedSeams& joined) {
  return {mesh, joined.given, options, *joined.solver, joined.scale, joined.seams};
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
  if (!out.solver) out.solver = std::make_unique<LogScale>(mesh, options.pool, out.ranks);
  out.steps.analysisSeconds += watch.lap();
  // Slits and splits are added one by one where needed; together they may be more than needed.
  out.steps.merges = mergeCharts(workOn(mesh, options, out));
  makeSymmetric(workOn(mesh, options, out));
  out.steps.mergeSeconds = watch.lap();
  return out;
}

Seams finishJoined(const SeamMesh& mesh, JoinedSeams joined, const SeamOptions& options,
                   SeamReport& report) {
  Stopwatch watch;
  Seams& seams = joined.seams;
  const auto goesOn = [&] { return options.isAuto && options.listener.tell(); };
  const bool isFair = goesOn() && fairSeams(workOn(mesh, options, joined));
  const bool isSolved = isFair && !makeSymmetric(workOn(mesh, options, joined));
  Seams found = seams;
  LogScales foundScale = joined.scale;
  if (goesOn()) shortenSeams(workOn(mesh, options, joined), isSolved);
  if (goesOn()) makeSymmetric(workOn(mesh, options, joined));
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
