#include "seam/cut_round.h"

#include "base/stopwatch.h"
#include "hole/fill_holes.h"
#include "seam/prediction.h"
#include "seam/slits.h"
#include "seam/split_charts.h"
#include "seam/stretched_holes.h"
#include "seam/symmetric_seams.h"

namespace abflat {
namespace {

/// The charts that a round begins with.
struct ChartsToCut {
  const PartInWork& part;
  const SeamOptions& options;
  const GivenCharts& given;
  const CutSurface& surface;
  const Prediction told;

  bool isUntouched(CutChartId c) const {
    const CutSurface::Chart& chart = surface.charts[c];
    return given.isUntouched(chart, triangleOf(part.toWhole(cornerOf(chart.firstTriangle, 0))));
  }
};

CutSurface cutOpeningHoles(const SeamMesh& mesh, const SeamOptions& options, Seams& seams) {
  CutSurface s = cutAlong(mesh, seams, options.listener);
  return openTouchedHoles(mesh, s, options.fillHoles, seams)
             ? cutAlong(mesh, seams, options.listener)
             : s;
}

IdVector<CutChartId, SplitFor> splitsAsked(const ChartsToCut& charts) {
  constexpr double kTellsNothing = 1.5;  // stretch above which the outline is unreliable
  IdVector<CutChartId, SplitFor> asked(charts.surface.charts.size(), SplitFor::Nothing);
  if (!charts.options.isAuto) return asked;
  for (const CutChartId c : asked.ids()) {
    if (charts.told.stretch[c] > kTellsNothing) continue;
    asked[c] = charts.isUntouched(c) ? SplitFor::Overlap : SplitFor::OverlapOrFill;
  }
  return asked;
}

/// Adds slits: towards the peaks with automatic seams, otherwise towards the costliest holes.
void addSlits(const ChartsToCut& charts, const CutPaths& paths, CutRound& round) {
  const CutSurface& s = charts.surface;
  const double most = charts.options.maxStretch;
  const std::vector<OpenVertex> ends =
      charts.options.isAuto ? slitEnds(paths, charts.told, round.scale, most)
                            : stretchedHoles(paths.mesh, s, charts.told, round.scale, most);
  for (const OpenVertex v : ends) {
    markPath(paths.mesh, paths.forest, v, round.seams);
    round.isChanged[s.chartOf(v)] = 1;
    ++round.slits;
  }
}

/// Slits and splits charts.
void cutCharts(const ChartsToCut& charts, CutRound& round) {
  const SeamMesh& mesh = charts.part.mesh();
  const CutSurface& s = charts.surface;
  const SeamOptions& options = charts.options;
  const ShapeOptions shape{options.leastFill, options.mostOverlap, options.longest};
  SplitCharts split = chartsToSplit(mesh, s, round.scale, shape, splitsAsked(charts));
  IdVector<CutChartId, std::uint8_t> isWanted;
  for (const CutChartId c : s.charts.ids())
    isWanted.push_back(split.asked[c] != SplitFor::Nothing ||
                       charts.told.stretch[c] > options.maxStretch);
  const PathForest forest = findPaths(mesh, s, {}, isWanted, options.listener);
  const CutPaths paths{mesh, s, forest};
  addSlits(charts, paths, round);
  options.listener.beat(mesh.triangleCount());
  round.splits = splitByShape(paths, round.scale, shape, split, round.seams, options.listener);
  for (const CutChartId c : s.charts.ids())
    if (split.asked[c] != SplitFor::Nothing) round.isChanged[c] = 1;
}

/// Cuts charts like their mirror images.
void cutImages(const PartInWork& part, const SeamOptions& options, const Seams& before,
               CutRound& round) {
  const Mirror mirror = part.part ? options.mirror.ofPart(*part.part) : options.mirror;
  for (const SurfaceCorner h :
       addImages(part.mesh(), mirror, before, round.seams, options.listener))
    round.isChanged[round.surface.chartOf(h)] = 1;
}

}  // namespace

CutRound cutRound(const PartInWork& part, const SeamOptions& options, const GivenCharts& given) {
  const SeamMesh& mesh = part.mesh();
  Stopwatch watch;
  CutRound out;
  out.seams = part.seams;
  out.surface = cutOpeningHoles(mesh, options, out.seams);
  LogScales u = part.solver->solve(out.surface, {});
  out.solveSeconds = watch.lap();
  if (u.empty() || !options.listener.tell()) return out;
  out.scale = std::move(u);
  const ChartsToCut charts{part, options, given, out.surface,
                           predictStretch(mesh, out.surface, out.scale)};
  options.listener.beat(mesh.triangleCount());
  out.isChanged.assign(out.surface.charts.size(), 0);
  const Seams before = options.mirror ? out.seams : Seams();
  cutCharts(charts, out);
  if (options.mirror) cutImages(part, options, before, out);
  return out;
}

}  // namespace abflat
