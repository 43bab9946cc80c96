#include "seam/find_in_rounds.h"

#include <algorithm>
#include <memory>

#include "base/stopwatch.h"
#include "hole/fill_holes.h"
#include "seam/cut_to_disks.h"
#include "seam/extract_charts.h"
#include "seam/fair_seams.h"
#include "seam/log_scale.h"
#include "seam/make_symmetric.h"
#include "seam/merge_charts.h"
#include "seam/pockets.h"
#include "seam/prediction.h"
#include "seam/shorten_seams.h"
#include "seam/slits.h"
#include "seam/split_charts.h"
#include "seam/stretched_holes.h"
#include "seam/symmetric_seams.h"

namespace abflat {
namespace {

/// For each chart the vertex of most extreme scale, such as the tip of something that sticks out.
IdVector<CutChartId, OpenVertex> extremes(const CutSurface& s, const Prediction& p,
                                          const LogScales& u) {
  IdVector<CutChartId, OpenVertex> out(s.charts.size());
  for (const OpenVertex v : s.vertices()) {
    const CutChartId c = s.chartOf(v);
    if (!out[c].exists() || p.at(c, u[s.meshVertex[v]]) > p.at(c, u[s.meshVertex[out[c]]]))
      out[c] = v;
  }
  return out;
}

}  // namespace

class SeamSearch::Finder {
 public:
  Finder(const SeamMesh& mesh, Seams given, const SeamOptions& options, SeamReport& report)
      : whole_(mesh),
        mesh_(&mesh),
        given_(std::move(given)),
        result_(given_),
        doubled_(doubledEdges(mesh)),
        options_(options),
        report_(report) {}

  void join();
  Seams finish();
  const Seams& joined() const { return result_; }
  const LogScales& scale() const { return u_; }

 private:
  void analyse();
  void begin();
  void cutInRounds();
  void open();
  bool improve();
  CutSurface cut();
  void slit(const CutPaths& paths, const LogScales& u);
  IdVector<CutChartId, SplitFor> splitsAsked(const CutSurface& s) const;
  void cutImages(const CutSurface& s, const Seams& before);
  bool finishUnchanged(const CutSurface& s);
  void handBack();
  SeamWork work() { return {whole_, given_, options_, *scale_, u_, result_}; }
  bool isWhole() const { return mesh_ == &whole_; }
  SurfaceCorner toWhole(SurfaceCorner h) const { return isWhole() ? h : part_.wholeHalfEdge[h]; }
  /// Whether the chart is still a disk as given, with all of its triangles and no edge used twice.
  bool isUntouched(const CutSurface& s, CutChartId chart) const {
    const CutSurface::Chart& now = s.charts[chart];
    const SurfaceTriangle triangle = triangleOf(toWhole(cornerOf(now.firstTriangle, 0)));
    const CutSurface::Chart& given = givenCharts_[givenChartOf_[triangle]];
    return given.isDisk() && given.triangles == now.triangles && given.edges == now.edges;
  }
  bool isKept(const CutSurface& s, CutChartId chart) const {
    return options_.keepDisks && isUntouched(s, chart);
  }
  bool goesOn() {
    report_.cancelled = report_.cancelled || (options_.keepsOn && !options_.keepsOn());
    return !report_.cancelled;
  }

  const Pulse pulse_{[this] { return goesOn(); }};
  const SeamMesh& whole_;
  const SeamMesh* mesh_;  ///< what is still being cut: whole_ or part_.mesh
  SeamPart part_;
  Seams seams_;           ///< of *mesh_
  Seams given_, result_;  ///< of the whole; seams_ are added when their part is done
  IdVector<CutChartId, CutSurface::Chart> givenCharts_;
  IdVector<SurfaceTriangle, CutChartId> givenChartOf_;  ///< of the whole
  const std::vector<SurfaceCorner> doubled_;
  const SeamOptions& options_;
  SeamReport& report_;
  std::unique_ptr<LogScale> scale_;
  Prediction prediction_;
  LogScales u_;                                   ///< of the whole, as last solved
  IdVector<CutChartId, std::uint8_t> isChanged_;  ///< in the current round
};

void SeamSearch::Finder::analyse() {
  Stopwatch watch;
  EliminationRanks& known = report_.eliminationRanks;
  EliminationRanks ranks;
  if (isWhole())
    ranks = known.empty() ? options_.eliminationRanks : known;
  else
    ranks = part_.ofVertices(known);
  scale_ = std::make_unique<LogScale>(*mesh_, options_.pool, std::move(ranks));
  if (isWhole() && known.empty()) known = scale_->eliminationRanks();
  report_.analysisSeconds += watch.lap();
}

void SeamSearch::Finder::open() {
  const CutSurface s = cutAlong(whole_, result_, pulse_);
  givenCharts_ = s.charts;
  givenChartOf_ = s.chartOfTriangle;
  std::vector<OpenVertex> closed;
  for (const CutSurface::Chart& c : s.charts)
    if (c.loops == 0) closed.push_back(s.tail(cornerOf(c.firstTriangle, 0)));
  IdVector<CutChartId, OpenVertex> roots;
  if (!closed.empty()) {
    const LogScales u = scale_->solve(s, closed);
    if (!u.empty()) roots = extremes(s, predictStretch(whole_, s, u), u);
  }
  const TopologyCut cut = cutToDisks(whole_, s, roots, result_, pulse_);
  report_.handleLoops = cut.handleLoops;
  report_.handleLength = cut.length;
  openPockets(whole_, doubled_, result_, pulse_);
}

CutSurface SeamSearch::Finder::cut() {
  CutSurface s = cutAlong(*mesh_, seams_, pulse_);
  return openTouchedHoles(*mesh_, s, options_.fillHoles, seams_) ? cutAlong(*mesh_, seams_, pulse_)
                                                                 : s;
}

/// Adds slits: towards the peaks with automatic seams, otherwise towards the costliest holes.
void SeamSearch::Finder::slit(const CutPaths& paths, const LogScales& u) {
  const CutSurface& s = paths.surface;
  const std::vector<OpenVertex> ends =
      options_.isAuto ? slitEnds(paths, prediction_, u, options_.maxStretch)
                      : stretchedHoles(*mesh_, s, prediction_, u, options_.maxStretch);
  for (const OpenVertex v : ends) {
    if (isKept(s, s.chartOf(v))) continue;
    markPath(*mesh_, paths.forest, v, seams_);
    isChanged_[s.chartOf(v)] = 1;
    ++report_.slits;
  }
}

IdVector<CutChartId, SplitFor> SeamSearch::Finder::splitsAsked(const CutSurface& s) const {
  constexpr double kTellsNothing = 1.5;  // stretch above which the outline is unreliable
  IdVector<CutChartId, SplitFor> asked(s.charts.size(), SplitFor::Nothing);
  if (!options_.isAuto) return asked;
  for (const CutChartId c : s.charts.ids()) {
    if (prediction_.stretch[c] > kTellsNothing || isKept(s, c)) continue;
    asked[c] = isUntouched(s, c) ? SplitFor::Overlap : SplitFor::OverlapOrFill;
  }
  return asked;
}

/// False if no chart was changed.
bool SeamSearch::Finder::improve() {
  Stopwatch watch;
  const CutSurface s = cut();
  const LogScales u = scale_->solve(s, {});
  report_.solveSeconds += watch.lap();
  if (u.empty() || !goesOn()) {
    handBack();
    return false;
  }
  for (const SurfaceVertex v : u.ids()) u_[isWhole() ? v : part_.wholeVertex[v]] = u[v];
  prediction_ = predictStretch(*mesh_, s, u);
  pulse_.beat(mesh_->triangleCount());
  isChanged_.assign(s.charts.size(), 0);
  const ShapeOptions shape{options_.leastFill, options_.mostOverlap, options_.longest};
  SplitCharts split = chartsToSplit(*mesh_, s, u, shape, splitsAsked(s));
  IdVector<CutChartId, std::uint8_t> isWanted;
  for (const CutChartId c : s.charts.ids())
    isWanted.push_back(split.asked[c] != SplitFor::Nothing ||
                       prediction_.stretch[c] > options_.maxStretch);
  const PathForest forest = findPaths(*mesh_, s, {}, isWanted, pulse_);
  const CutPaths paths{*mesh_, s, forest};
  const Seams before = options_.mirror ? seams_ : Seams();
  slit(paths, u);
  pulse_.beat(mesh_->triangleCount());
  report_.splits += splitByShape(paths, u, shape, split, seams_, pulse_);
  for (const CutChartId c : s.charts.ids())
    if (split.asked[c] != SplitFor::Nothing) isChanged_[c] = 1;
  if (options_.mirror) cutImages(s, before);
  return finishUnchanged(s);
}

/// Cuts charts like their mirror images.
void SeamSearch::Finder::cutImages(const CutSurface& s, const Seams& before) {
  const Mirror mirror = isWhole() ? options_.mirror : options_.mirror.ofPart(part_);
  for (const SurfaceCorner h : addImages(*mesh_, mirror, before, seams_, pulse_))
    isChanged_[s.chartOf(h)] = 1;
}

/// Hands back finished charts and, if the rest is much smaller, continues on the rest as a part of
/// its own. False if all is done.
bool SeamSearch::Finder::finishUnchanged(const CutSurface& s) {
  std::size_t changed = 0;
  for (const CutChartId c : s.charts.ids())
    if (isChanged_[c]) changed += s.charts[c].triangles;
  constexpr std::size_t kMuchSmaller = 2;
  if (changed > 0 && changed * kMuchSmaller > mesh_->triangleCount()) return true;
  handBack();
  if (changed == 0) return false;
  SeamPart rest = extractCharts(*mesh_, s, isChanged_, pulse_);
  Seams seams;
  // What was cut before this round is on the part's boundary.
  for (const SurfaceCorner h : rest.wholeHalfEdge) seams.push_back(seams_[h] && s.twin[h].exists());
  if (!isWhole()) rest.embedIn(part_);
  part_ = std::move(rest);
  seams_ = std::move(seams);
  mesh_ = &part_.mesh;
  analyse();
  return true;
}

void SeamSearch::Finder::handBack() {
  for (const SurfaceCorner h : seams_.ids())
    if (seams_[h]) result_[toWhole(h)] = 1;
}

void SeamSearch::Finder::begin() {
  for (const SurfaceCorner h : options_.first.ids())
    if (options_.first[h] && whole_.twin[h].exists()) result_[h] = 1;
  const Seams before = result_;
  open();
  if (options_.mirror) addImages(whole_, options_.mirror, before, result_, pulse_);
}

void SeamSearch::Finder::cutInRounds() {
  seams_ = result_;
  u_.assign(whole_.vertexCount(), 0);
  constexpr int kMostRounds = 40;
  const bool opensHoles = !whole_.hole.empty() && options_.fillHoles == FillHoles::Auto;
  bool isDone = !options_.isAuto && !opensHoles;
  while (!isDone && report_.rounds < kMostRounds && goesOn()) {
    ++report_.rounds;
    isDone = !improve();
  }
  handBack();
  if (!whole_.hole.empty())
    openTouchedHoles(whole_, cutAlong(whole_, result_, pulse_), options_.fillHoles, result_);
}

void SeamSearch::Finder::join() {
  analyse();
  begin();
  cutInRounds();
  Stopwatch watch;
  if (!options_.isAuto || !goesOn()) return;
  if (!isWhole()) {
    mesh_ = &whole_;
    part_ = SeamPart();
    analyse();
  }
  // Slits and splits are added one by one where needed; together they may be more than needed.
  report_.merges = mergeCharts(work());
  makeSymmetric(work());
  report_.mergeSeconds = watch.lap();
}

Seams SeamSearch::Finder::finish() {
  Stopwatch watch;
  const bool isFair = options_.isAuto && goesOn() && fairSeams(work());
  const bool isSolved = isFair && !makeSymmetric(work());
  report_.found = result_;
  report_.foundScale = u_;
  if (options_.isAuto && goesOn()) shortenSeams(work(), isSolved);
  if (options_.isAuto) makeSymmetric(work());
  openPockets(whole_, doubled_, result_, pulse_);
  for (const SurfaceCorner h : result_.ids())
    if (result_[h]) report_.found[h] = 1;
  report_.mergeSeconds += watch.lap();
  const CutSurface s = cutAlong(whole_, result_, pulse_);
  report_.stretch = predictStretch(whole_, s, u_).total;
  for (const CutSurface::Chart& chart : s.charts)
    report_.charts += !whole_.isFilling(chart.firstTriangle);
  report_.scale = std::move(u_);
  return std::move(result_);
}

SeamSearch::SeamSearch(const SeamMesh& mesh, Seams given, const SeamOptions& options,
                       SeamReport& report)
    : finder_(std::make_unique<Finder>(mesh, std::move(given), options, report)) {}

SeamSearch::~SeamSearch() = default;

void SeamSearch::join() { finder_->join(); }
Seams SeamSearch::finish() { return finder_->finish(); }
const Seams& SeamSearch::joined() const { return finder_->joined(); }
const LogScales& SeamSearch::scale() const { return finder_->scale(); }

Seams findInRounds(const SeamMesh& mesh, Seams given, const SeamOptions& options,
                   SeamReport& report) {
  SeamSearch search(mesh, std::move(given), options, report);
  search.join();
  return search.finish();
}

}  // namespace abflat
