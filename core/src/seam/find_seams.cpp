#include "seam/find_seams.h"

#include <algorithm>
#include <cmath>

#include "seam/chords.h"
#include "seam/cut_to_disks.h"
#include "seam/log_scale.h"
#include "seam/outline.h"
#include "seam/prediction.h"
#include "seam/slits.h"
#include "stopwatch.h"

namespace abflat {
namespace {

std::vector<std::uint32_t> firstVertices(const CutSurface& s) {
  std::vector<std::uint32_t> out;
  for (const CutSurface::Chart& c : s.charts) out.push_back(s.vertexOfCorner[3 * c.firstTriangle]);
  return out;
}

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

class Finder {
 public:
  Finder(const SeamMesh& mesh, const SeamOptions& options, SeamReport& report)
      : mesh_(mesh), options_(options), report_(report) {}

  void run(Seams& seams);

 private:
  void open(Seams& seams);
  bool improve(Seams& seams);
  bool goesOn() const { return !options_.keepsOn || options_.keepsOn(); }

  const SeamMesh& mesh_;
  const SeamOptions& options_;
  SeamReport& report_;
  std::unique_ptr<LogScale> scale_;
};

void Finder::open(Seams& seams) {
  const CutSurface s = cutAlong(mesh_, seams);
  std::vector<std::uint32_t> anchors = firstVertices(s);
  for (std::size_t c = 0; c < anchors.size(); ++c)
    if (s.charts[c].loops > 0) anchors[c] = kNone;
  std::vector<std::uint32_t> closed;
  for (const std::uint32_t a : anchors)
    if (a != kNone) closed.push_back(a);
  std::vector<std::uint32_t> roots;
  if (!closed.empty()) {
    const std::vector<double> u = scale_->solve(s, closed);
    if (!u.empty()) roots = extremes(s, predictStretch(mesh_, s, u), u);
  }
  const TopologyCut cut = cutToDisks(mesh_, s, std::move(roots), seams);
  report_.handleLoops = cut.handleLoops;
  report_.handleLength = cut.length;
}

bool Finder::improve(Seams& seams) {
  Stopwatch watch;
  const CutSurface s = cutAlong(mesh_, seams);
  const std::vector<double> u = scale_->solve(s, {});
  report_.solveSeconds += watch.lap();
  if (u.empty()) return false;
  const Prediction p = predictStretch(mesh_, s, u);
  report_.stretch = p.total;
  const PathForest forest = findPaths(mesh_, s, {});
  const std::vector<std::uint32_t> ends = slitEnds(mesh_, s, forest, p, u, options_.maxStretch);
  double added = 0;
  for (const std::uint32_t v : ends) added += markPath(mesh_, forest, v, seams);
  report_.slits += static_cast<std::uint32_t>(ends.size());
  ChordFinder chords(mesh_, s, forest);
  for (std::uint32_t c = 0; c < s.charts.size(); ++c) {
    if (p.stretch[c] > 1.5 || s.charts[c].triangles < 2) continue;
    const Shape shape =
        measureShape(predictOutline(mesh_, s, s.charts[c].loopBegin, u), s.charts[c].area);
    if (shape.fill >= options_.leastFill && shape.overlap <= options_.mostOverlap) continue;
    const Chord chord = chords.best(c, shape.crossings);
    if (chord.h == kNone) continue;
    added += markEdge(mesh_, chord.h, seams);
    added += markPath(mesh_, forest, s.vertexOfCorner[chord.h], seams);
    added += markPath(mesh_, forest, s.vertexOfCorner[nextCorner(chord.h)], seams);
    ++report_.splits;
  }
  return added > 0;
}

void Finder::run(Seams& seams) {
  Stopwatch watch;
  scale_ = std::make_unique<LogScale>(mesh_, options_.pool);
  report_.analysisSeconds = watch.lap();
  open(seams);
  constexpr int kMostRounds = 30;
  while (report_.rounds < kMostRounds && goesOn()) {
    ++report_.rounds;
    if (!improve(seams)) break;
  }
  report_.cancelled = !goesOn();
}

}  // namespace

Seams findSeams(const SeamMesh& mesh, Seams given, const SeamOptions& options, SeamReport* report) {
  Stopwatch watch;
  SeamReport own;
  Seams seams = std::move(given);
  seams.resize(mesh.twin.size(), 0);
  if (mesh.triangleCount() > 0) Finder(mesh, options, own).run(seams);
  const CutSurface s = cutAlong(mesh, seams);
  own.charts = static_cast<std::uint32_t>(s.charts.size());
  for (std::uint32_t h = 0; h < seams.size(); ++h)
    if (seams[h]) own.seamLength += mesh.length[h] / 2;
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
