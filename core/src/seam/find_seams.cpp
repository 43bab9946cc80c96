#include "seam/find_seams.h"

#include <algorithm>
#include <cmath>

#include "base/stopwatch.h"
#include "hole/fill_holes.h"
#include "seam/cut_to_disks.h"
#include "seam/extract_charts.h"
#include "seam/fair_seams.h"
#include "seam/log_scale.h"
#include "seam/merge_charts.h"
#include "seam/prediction.h"
#include "seam/shorten_seams.h"
#include "seam/slits.h"
#include "seam/split_charts.h"
#include "seam/stretched_holes.h"
#include "seam/symmetric_seams.h"

namespace abflat {
namespace {

/// For each chart the vertex of most extreme scale: the tip of something that sticks out.
std::vector<std::uint32_t> extremes(const CutSurface& s, const Prediction& p,
                                    const std::vector<double>& u) {
  std::vector<std::uint32_t> out(s.charts.size(), kNone);
  for (std::uint32_t v = 0; v < s.vertexCount(); ++v) {
    const std::uint32_t c = s.chartOfVertex(v);
    if (out[c] == kNone || p.at(c, u[s.meshVertex[v]]) > p.at(c, u[s.meshVertex[out[c]]]))
      out[c] = v;
  }
  return out;
}

/// Vertices inside, in order, that only two triangles meet at: no flat layout has both.
std::vector<std::uint32_t> verticesOfTwo(const SeamMesh& mesh) {
  std::vector<std::uint8_t> corners(mesh.vertexCount(), 0);
  for (std::uint32_t c = 0; c < mesh.vertexOfCorner.size(); ++c) {
    std::uint8_t& count = corners[mesh.vertexOfCorner[c]];
    // At the boundary there may be any number.
    if (mesh.twin[c] == kNone || mesh.twin[prevCorner(c)] == kNone) count = 3;
    if (count < 3) ++count;
  }
  std::vector<std::uint32_t> out;
  for (std::uint32_t v = 0; v < corners.size(); ++v)
    if (corners[v] == 2) out.push_back(v);
  return out;
}

/// Cuts in rounds. A chart that a round leaves as it is stays so; the rounds go on with the others
/// alone as soon as these are much less than all.
class Finder {
 public:
  Finder(const SeamMesh& mesh, Seams given, const SeamOptions& options, SeamReport& report)
      : whole_(mesh),
        mesh_(&mesh),
        given_(std::move(given)),
        result_(given_),
        options_(options),
        report_(report) {}

  Seams run();

 private:
  void analyse();
  void open();
  void openBetweenTwo();
  bool improve();
  CutSurface cut();
  void slit(const CutSurface& s, const PathForest& forest, const std::vector<double>& u);
  std::vector<SplitFor> splitsAsked(const CutSurface& s) const;
  bool finishUnchanged(const CutSurface& s);
  void handBack();
  bool isWhole() const { return mesh_ == &whole_; }
  std::uint32_t toWhole(std::uint32_t h) const { return isWhole() ? h : part_.halfEdge[h]; }
  /// A disk as it was given: all of its triangles, and no edge twice.
  bool isUntouched(const CutSurface& s, std::uint32_t chart) const {
    const CutSurface::Chart& now = s.charts[chart];
    const std::uint32_t triangle = toWhole(3 * now.firstTriangle) / 3;
    const CutSurface::Chart& given = givenCharts_[givenChartOf_[triangle]];
    return given.isDisk() && given.triangles == now.triangles && given.edges == now.edges;
  }
  bool isKept(const CutSurface& s, std::uint32_t chart) const {
    return options_.keepDisks && isUntouched(s, chart);
  }
  bool goesOn() {
    report_.cancelled = report_.cancelled || (options_.keepsOn && !options_.keepsOn());
    return !report_.cancelled;
  }

  const Pulse pulse_{[this] { return goesOn(); }};
  const SeamMesh& whole_;
  const SeamMesh* mesh_;  ///< what is still being cut: the whole or part_.mesh
  SeamPart part_;
  Seams seams_;           ///< of *mesh_
  Seams given_, result_;  ///< of the whole; seams_ are added when their part is done
  std::vector<CutSurface::Chart> givenCharts_;
  std::vector<std::uint32_t> givenChartOf_;
  const SeamOptions& options_;
  SeamReport& report_;
  std::unique_ptr<LogScale> scale_;
  Prediction prediction_;
  std::vector<double> u_;                ///< per vertex of the whole, as it was last told
  std::vector<std::uint8_t> isChanged_;  ///< per chart, in the round at work
};

void Finder::analyse() {
  Stopwatch watch;
  std::vector<std::uint32_t> place;
  if (isWhole())
    place = report_.place.empty() ? options_.place : report_.place;
  else
    for (const std::uint32_t v : part_.vertex) place.push_back(report_.place[v]);
  scale_ = std::make_unique<LogScale>(*mesh_, options_.pool, std::move(place));
  if (isWhole()) report_.place = scale_->place();
  report_.analysisSeconds += watch.lap();
}

void Finder::open() {
  const CutSurface s = cutAlong(whole_, result_, pulse_);
  givenCharts_ = s.charts;
  givenChartOf_ = s.chartOfTriangle;
  std::vector<std::uint32_t> closed;
  for (const CutSurface::Chart& c : s.charts)
    if (c.loops == 0) closed.push_back(s.vertexOfCorner[3 * c.firstTriangle]);
  std::vector<std::uint32_t> roots;
  if (!closed.empty()) {
    const std::vector<double> u = scale_->solve(s, closed);
    if (!u.empty()) roots = extremes(s, predictStretch(whole_, s, u), u);
  }
  const TopologyCut cut = cutToDisks(whole_, s, std::move(roots), result_, pulse_);
  report_.handleLoops = cut.handleLoops;
  report_.handleLength = cut.length;
  openBetweenTwo();
}

/// Cuts to vertices between two triangles, so that these need not lie on each other.
void Finder::openBetweenTwo() {
  const std::vector<std::uint32_t> ends = verticesOfTwo(whole_);
  if (ends.empty()) return;
  const CutSurface s = cutAlong(whole_, result_, pulse_);
  const PathForest forest = findPaths(whole_, s, {}, {}, pulse_);
  for (std::uint32_t v = 0; v < s.vertexCount(); ++v)
    if (!s.isBoundary[v] && std::binary_search(ends.begin(), ends.end(), s.meshVertex[v]))
      markPath(whole_, forest, v, result_);
}

CutSurface Finder::cut() {
  CutSurface s = cutAlong(*mesh_, seams_, pulse_);
  return openTouchedHoles(*mesh_, s, options_.fillHoles, seams_) ? cutAlong(*mesh_, seams_, pulse_)
                                                                 : s;
}

/// With automatic seams towards the peaks, otherwise towards the holes that cost most.
void Finder::slit(const CutSurface& s, const PathForest& forest, const std::vector<double>& u) {
  const std::vector<std::uint32_t> ends =
      options_.isAuto ? slitEnds(*mesh_, s, forest, prediction_, u, options_.maxStretch)
                      : stretchedHoles(*mesh_, s, prediction_, u, options_.maxStretch);
  for (const std::uint32_t v : ends) {
    if (isKept(s, s.chartOfVertex(v))) continue;
    markPath(*mesh_, forest, v, seams_);
    isChanged_[s.chartOfVertex(v)] = 1;
    ++report_.slits;
  }
}

std::vector<SplitFor> Finder::splitsAsked(const CutSurface& s) const {
  constexpr double kTellsNothing = 1.5;  // stretch above which the outline is not to be trusted
  std::vector<SplitFor> asked(s.charts.size(), SplitFor::Nothing);
  if (!options_.isAuto) return asked;
  for (std::uint32_t c = 0; c < s.charts.size(); ++c) {
    if (prediction_.stretch[c] > kTellsNothing || isKept(s, c)) continue;
    asked[c] = isUntouched(s, c) ? SplitFor::Overlap : SplitFor::OverlapOrFill;
  }
  return asked;
}

/// False when no chart was changed.
bool Finder::improve() {
  Stopwatch watch;
  const CutSurface s = cut();
  const std::vector<double> u = scale_->solve(s, {});
  report_.solveSeconds += watch.lap();
  if (u.empty() || !goesOn()) {
    handBack();
    return false;
  }
  for (std::uint32_t v = 0; v < u.size(); ++v) u_[isWhole() ? v : part_.vertex[v]] = u[v];
  prediction_ = predictStretch(*mesh_, s, u);
  pulse_.beat(mesh_->triangleCount());
  isChanged_.assign(s.charts.size(), 0);
  const ShapeOptions shape{options_.leastFill, options_.mostOverlap, options_.longest};
  std::vector<SplitFor> asked = splitsAsked(s);
  const std::vector<Shape> shapes = shapesToSplit(*mesh_, s, u, shape, asked);
  std::vector<std::uint8_t> isWanted;
  for (std::size_t c = 0; c < s.charts.size(); ++c)
    isWanted.push_back(asked[c] != SplitFor::Nothing ||
                       prediction_.stretch[c] > options_.maxStretch);
  const PathForest forest = findPaths(*mesh_, s, {}, isWanted, pulse_);
  slit(s, forest, u);
  pulse_.beat(mesh_->triangleCount());
  report_.splits += splitByShape(*mesh_, s, forest, u, shapes, shape, asked, seams_, pulse_);
  for (std::size_t c = 0; c < s.charts.size(); ++c)
    if (asked[c] != SplitFor::Nothing) isChanged_[c] = 1;
  return finishUnchanged(s);
}

/// Hands back what is done and keeps the rest as a part of its own where that is much smaller;
/// false when all is done.
bool Finder::finishUnchanged(const CutSurface& s) {
  std::size_t changed = 0;
  for (std::size_t c = 0; c < s.charts.size(); ++c)
    if (isChanged_[c]) changed += s.charts[c].triangles;
  constexpr std::size_t kMuchSmaller = 2;
  if (changed > 0 && changed * kMuchSmaller > mesh_->triangleCount()) return true;
  handBack();
  if (changed == 0) return false;
  SeamPart rest = extractCharts(*mesh_, s, isChanged_, pulse_);
  Seams seams;
  for (std::uint32_t& h : rest.halfEdge) {
    // What was cut before this round is the part's boundary.
    seams.push_back(seams_[h] && s.twin[h] != kNone);
    h = toWhole(h);
  }
  if (!isWhole())
    for (std::uint32_t& v : rest.vertex) v = part_.vertex[v];
  part_ = std::move(rest);
  seams_ = std::move(seams);
  mesh_ = &part_.mesh;
  analyse();
  return true;
}

void Finder::handBack() {
  for (std::uint32_t h = 0; h < seams_.size(); ++h)
    if (seams_[h]) result_[toWhole(h)] = 1;
}

Seams Finder::run() {
  analyse();
  for (std::size_t h = 0; h < options_.first.size(); ++h)
    if (options_.first[h] && whole_.twin[h] != kNone) result_[h] = 1;
  open();
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
  Stopwatch watch;
  if (options_.isAuto && goesOn() && !isWhole()) {
    mesh_ = &whole_;
    part_ = SeamPart();
    analyse();
  }
  // Slits and splits are made where each is needed; together they may be more than that.
  if (options_.isAuto && goesOn())
    report_.merges = mergeCharts(whole_, given_, options_, *scale_, u_, result_);
  const bool isSolved =
      options_.isAuto && goesOn() && fairSeams(whole_, given_, options_, *scale_, u_, result_);
  report_.found = result_;
  report_.foundScale = u_;
  if (options_.isAuto && goesOn())
    shortenSeams(whole_, given_, options_, *scale_, u_, result_, isSolved);
  report_.mergeSeconds = watch.lap();
  const CutSurface s = cutAlong(whole_, result_, pulse_);
  report_.stretch = predictStretch(whole_, s, u_).total;
  for (const CutSurface::Chart& chart : s.charts)
    report_.charts += !whole_.isFilling(chart.firstTriangle);
  report_.scale = std::move(u_);
  return std::move(result_);
}

double lengthOf(const SeamMesh& mesh, const Seams& seams) {
  double sum = 0;
  for (std::uint32_t h = 0; h < seams.size(); ++h)
    if (seams[h] && mesh.isOnSurface(h)) sum += mesh.length[h] / 2;
  return sum;
}

/// Shorter where they run along creases.
double costOf(const SeamMesh& mesh, const Seams& seams) {
  double sum = 0;
  for (std::uint32_t h = 0; h < seams.size(); ++h)
    if (seams[h] && mesh.isOnSurface(h)) sum += mesh.cost[h] / 2;
  return sum;
}

/// Finds seams of a mesh in which nothing is cut yet on one side of its plane of symmetry alone.
class SymmetricFinder {
 public:
  SymmetricFinder(const SeamMesh& mesh, const SeamOptions& options)
      : mesh_(mesh), options_(options) {}

  /// Replaces `seams`, which `report` is about, by symmetric ones where these are to be preferred.
  void run(Seams& seams, SeamReport& report) const {
    const double cost = costOf(mesh_, seams);
    if (options_.symmetricSeams == SymmetricSeams::Never || cost == 0) return;
    const Mirror mirror = findMirror(mesh_, Pulse(options_.keepsOn));
    if (!mirror || mirroredShare(mesh_, mirror, seams) > kSymmetric) return;
    const std::optional<SeamPart> half = halfOf(mesh_, mirror, options_.fillHoles);
    if (!half) return;
    const double plane = costOf(mesh_, unfold(mesh_, mirror, *half, {}));
    if (isTooMuch(plane, cost * kMostOfPlane)) return;
    const Seams found = seamsOfHalf(*half, report.place);
    const double least = 2 * costOf(half->mesh, found) + kLeastOfPlane * plane;
    if (isTooMuch(least, cost)) return;
    SeamOptions options = options_;
    options.place = report.place;
    options.first = unfold(mesh_, mirror, *half, found);
    SeamReport own;
    Seams symmetric = Finder(mesh_, Seams(mesh_.twin.size(), 0), options, own).run();
    if (own.cancelled) report.cancelled = true;
    if (own.cancelled || isTooMuch(own.charts, report.charts) ||
        isTooMuch(costOf(mesh_, symmetric), cost))
      return;
    seams = std::move(symmetric);
    report = std::move(own);
  }

 private:
  /// Share of seams that are mirrored already: it is a matter of few edges.
  static constexpr double kSymmetric = 0.9;
  /// Measured, of what lies in the plane: where it is more than the former of all seams, or the
  /// latter of it with the seams beside are, they come out longer.
  static constexpr double kMostOfPlane = 0.7, kLeastOfPlane = 0.6;

  bool isTooMuch(double now, double most) const {
    return options_.symmetricSeams == SymmetricSeams::Auto && now > most;
  }

  Seams seamsOfHalf(const SeamPart& half, const std::vector<std::uint32_t>& place) const {
    SeamOptions options = options_;
    options.place.clear();
    for (const std::uint32_t v : half.vertex) options.place.push_back(place[v]);
    SeamReport own;
    return Finder(half.mesh, Seams(half.halfEdge.size(), 0), options, own).run();
  }

  const SeamMesh& mesh_;
  const SeamOptions& options_;
};

}  // namespace

Seams findSeams(const SeamMesh& mesh, Seams given, const SeamOptions& options, SeamReport* report) {
  Stopwatch watch;
  SeamReport own;
  Seams seams = std::move(given);
  seams.resize(mesh.twin.size(), 0);
  for (std::uint32_t h = 0; h < seams.size(); ++h) {
    if (mesh.twin[h] == kNone) seams[h] = 0;
    if (seams[h]) seams[mesh.twin[h]] = seams[h] = 1;
  }
  const bool isFree = options.isAuto && options.first.empty() &&
                      std::find(seams.begin(), seams.end(), 1) == seams.end();
  if (mesh.triangleCount() > 0) seams = Finder(mesh, std::move(seams), options, own).run();
  if (isFree && !own.cancelled) SymmetricFinder(mesh, options).run(seams, own);
  own.seamLength = lengthOf(mesh, seams);
  const double size = std::sqrt(mesh.totalArea());
  if (size > 0) {
    own.seamLength /= size;
    own.handleLength /= size;
  }
  own.seconds = watch.lap();
  if (report) *report = own;
  return seams;
}

}  // namespace abflat
