#include "seam/merge_charts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <utility>

#include "base/stable_order.h"
#include "seam/extract_charts.h"
#include "seam/log_scale.h"
#include "seam/prediction.h"
#include "seam/room.h"
#include "seam/seam_value.h"

namespace abflat {
namespace {

/// How much larger the convex hull of a union may be than the hulls of its charts together. Hulls
/// predict the room needed for packing.
constexpr double kMostRoom = 1.05;

/// Limits for a union that is joined along only a part of its seam: its hull as above, the share of
/// its hull that it fills, and its extent. The latter is relative to the root of the mesh's area,
/// so that the union fits into a well-filled square from corner to corner.
constexpr double kMostRoomOfHinged = 1.4, kLeastFill = 0.3, kLongest = 1.9;

/// A path along which two charts touch. Opening it joins two disks into one.
struct SharedRun {
  CutChartId a, b;                   ///< a < b
  std::vector<SurfaceCorner> edges;  ///< half-edges of a, in order
  BoundaryIndex begin;               ///< index of the first edge in the loop of a
  double length = 0, cost = 0;
};

/// What would be joined, on a surface of its own, or on the whole surface if that is mostly what is
/// joined.
struct Trial {
  std::unique_ptr<SeamPart> part;  ///< null: the whole
  CutSurface joined, apart;
  LogScales u;                    ///< of the joined surface
  Prediction prediction, before;  ///< joined, apart

  /// The half-edge of the trial that corresponds to one of the whole.
  SurfaceCorner inTrial(SurfaceCorner h) const {
    if (!part) return h;
    const auto& all = part->wholeHalfEdge;
    return SurfaceCorner(std::lower_bound(all.begin(), all.end(), h) - all.begin());
  }
};

using ChartOutlines = IdVector<CutChartId, Outline>;

class Merger {
 public:
  explicit Merger(const SeamWork& work)
      : work_(work),
        mesh_(work.mesh),
        options_(work.options),
        u_(work.u),
        seams_(work.seams),
        longest_(std::min(options_.longest, kLongest * std::sqrt(mesh_.totalArea()))),
        isRefused_(seams_.size(), 0) {}

  std::uint32_t run() {
    std::uint32_t done = joinAll();
    isHinge_ = true;
    std::fill(isRefused_.begin(), isRefused_.end(), 0);
    unpromising_.clear();
    return done + joinAll();
  }

 private:
  std::uint32_t joinAll() {
    std::uint32_t done = 0;
    while (work_.goesOn()) {
      CutSurface apart = cutAlong(mesh_, seams_, pulse_);
      const std::vector<SharedRun> runs = matching(apart);
      if (runs.empty()) break;
      const std::uint32_t now = joinWherePossible(runs, std::move(apart));
      if (now == 0 && !isHinge_) break;  // the other runs are shorter
      done += now;
    }
    return done;
  }

  /// Parts of the runs along which charts could stay joined; for each run, those nearest to its
  /// middle come first.
  std::vector<SharedRun> hingesOf(const CutSurface& s, const std::vector<SharedRun>& runs) const {
    constexpr double kWidth = 0.15;  // relative to the root of the smaller chart's area
    constexpr int kMost = 5;         // per run
    std::vector<SharedRun> out;
    for (const SharedRun& run : runs) {
      const double width = kWidth * std::sqrt(std::min(s.charts[run.a].area, s.charts[run.b].area));
      const int slots = static_cast<int>(std::min<double>(kMost, run.length / width));
      for (int k = 0; k < slots; ++k) {
        const int slot = slots / 2 + (k % 2 == 1 ? (k + 1) / 2 : -k / 2);
        const double middle = run.length * (slot + 0.5) / slots;
        if (SharedRun part = partOf(run, middle - width / 2, middle + width / 2);
            !part.edges.empty())
          out.push_back(std::move(part));
      }
    }
    return out;
  }

  /// The edges of the run that begin between two distances along it.
  SharedRun partOf(const SharedRun& run, double from, double to) const {
    SharedRun out{run.a, run.b, {}, run.begin, 0, 0};
    double passed = 0;
    for (const SurfaceCorner h : run.edges) {
      if (passed < from) ++out.begin;
      if (passed >= from && passed < to) {
        out.edges.push_back(h);
        out.length += mesh_.length[h];
        out.cost += mesh_.cost[h];
      }
      passed += mesh_.length[h];
    }
    return out;
  }

  /// The chart on the other side of an edge, if the seam there may be removed.
  CutChartId behind(const CutSurface& s, SurfaceCorner h) const {
    return work_.kept[h] || !mesh_.isOnSurface(h) ? CutChartId() : s.chartOf(mesh_.twin[h]);
  }

  void addRuns(const CutSurface& s, CutChartId chart, std::vector<SharedRun>& out) const {
    const BoundaryLoop loop = s.outline(chart);
    const std::size_t n = loop.size();
    std::size_t start = 0;  // index where a run begins
    const auto behindAt = [&](std::size_t i) { return behind(s, loop[BoundaryIndex(i % n)]); };
    while (start < n && behindAt(start) == behindAt(start + n - 1)) ++start;
    if (start == n) return;  // a single chart goes all the way round
    CutChartId last;
    for (std::size_t i = 0; i < n; ++i) {
      const BoundaryIndex at((start + i) % n);
      const SurfaceCorner h = loop[at];
      const CutChartId other = behind(s, h);
      const bool isNew = other != last;
      last = other;
      if (!other.exists() || other <= chart || !s.charts[other].isDisk()) continue;
      if (isNew) out.push_back({chart, other, {}, at, 0, 0});
      out.back().edges.push_back(h);
      out.back().length += mesh_.length[h];
      out.back().cost += mesh_.cost[h];
    }
  }

  /// Points of the two outlines that the run brings together.
  OutlinePairs pairsOf(const CutSurface& s, const ChartOutlines& outlines,
                       const SharedRun& run) const {
    const BoundaryLoop loop = s.outline(run.b);
    const std::size_t n = outlines[run.a].size(), m = loop.size();
    const auto first = std::find(loop.begin(), loop.end(), mesh_.twin[run.edges.front()]);
    const auto begin = static_cast<std::size_t>(first - loop.begin());
    OutlinePairs pairs;
    for (std::size_t i = 0; i <= run.edges.size(); ++i)
      pairs.emplace_back((run.begin + i) % n, (begin + 1 + m - i) % m);
    return pairs;
  }

  /// Whether the charts' separate layouts fit together.
  bool isPromising(const CutSurface& s, const ChartOutlines& outlines, const SharedRun& run) const {
    const OutlinePairs pairs = pairsOf(s, outlines, run);
    const Outline &a = outlines[run.a], &b = outlines[run.b];
    if (!isHinge_ && roomTogether(a, b, pairs) <= kMostRoom) return true;
    if (!isHinge_ && longestExtent(a) + longestExtent(b) > options_.speck) return false;
    // Joining along a part of a seam changes so little that the union is as good as known.
    const Outline both = outlineTogether(a, b, pairs);
    if (both.empty()) return false;
    const Shape shape = measureShape(both);
    return shape.crossings.empty() && shape.extent <= longest_ && shape.fill >= kLeastFill;
  }

  /// The same, but remembers pairs that do not fit, so that each is checked only once. Charts only
  /// grow, so a chart with as many triangles as before is unchanged.
  bool stillPromises(const CutSurface& s, ChartOutlines& outlines, const SharedRun& run) {
    const std::array<std::size_t, 3> sizes = {s.charts[run.a].triangles, s.charts[run.b].triangles,
                                              run.edges.size()};
    const auto known = unpromising_.find(run.edges.front());
    if (known != unpromising_.end() && known->second == sizes) return false;
    for (const CutChartId c : {run.a, run.b})
      if (outlines[c].empty()) outlines[c] = predictOutline(mesh_, s, c, u_);
    const bool promises = isPromising(s, outlines, run);
    if (!promises) unpromising_[run.edges.front()] = sizes;
    return promises;
  }

  bool isRefused(const SharedRun& run) const {
    return std::any_of(run.edges.begin(), run.edges.end(),
                       [&](SurfaceCorner h) { return isRefused_[h]; });
  }

  /// The longest promising runs, no two of which share a chart.
  std::vector<SharedRun> matching(const CutSurface& s) {
    std::vector<SharedRun> runs;
    ChartOutlines outlines(s.charts.size());
    for (const CutChartId c : s.charts.ids())
      if (s.charts[c].isDisk()) addRuns(s, c, runs);
    sortStably(runs, [](const SharedRun& x, const SharedRun& y) {
      return x.cost != y.cost ? x.cost > y.cost : x.edges.front() < y.edges.front();
    });
    if (isHinge_) runs = hingesOf(s, runs);
    IdVector<CutChartId, std::uint8_t> isUsed(s.charts.size(), 0);
    std::vector<SharedRun> out;
    for (SharedRun& run : runs) {
      if (isUsed[run.a] || isUsed[run.b] || isRefused(run) || !stillPromises(s, outlines, run))
        continue;
      isUsed[run.a] = isUsed[run.b] = 1;
      out.push_back(std::move(run));
    }
    return out;
  }

  void mark(const SharedRun& run, bool isSeam) {
    for (const SurfaceCorner h : run.edges) seams_[h] = seams_[mesh_.twin[h]] = isSeam;
  }

  void refuse(const SharedRun& run) {
    for (const SurfaceCorner h : run.edges) isRefused_[h] = isRefused_[mesh_.twin[h]] = 1;
  }

  /// Solves for the unions of the charts that the runs, which are already opened, separate.
  /// `apart`: the surface before that.
  Trial tryOut(const std::vector<SharedRun>& runs, CutSurface apart) {
    constexpr std::size_t kMost = 2;  // times as many: the elimination order is for the whole
    CutSurface s = cutAlong(mesh_, seams_, pulse_);
    IdVector<CutChartId, std::uint8_t> isUnion(s.charts.size(), 0);
    for (const SharedRun& run : runs) isUnion[s.chartOf(run.edges.front())] = 1;
    std::size_t triangles = 0;
    for (const CutChartId c : s.charts.ids())
      if (isUnion[c]) triangles += s.charts[c].triangles;
    if (kMost * triangles < mesh_.triangleCount()) return tryPart(runs, s, isUnion);
    Trial out;
    out.apart = std::move(apart);
    out.joined = std::move(s);
    out.u = work_.scale.solve(out.joined, {});
    if (!out.u.empty()) out.prediction = predictStretch(mesh_, out.joined, out.u);
    out.before = predictStretch(mesh_, out.apart, u_);
    return out;
  }

  Trial tryPart(const std::vector<SharedRun>& runs, const CutSurface& s,
                const IdVector<CutChartId, std::uint8_t>& isUnion) const {
    Trial out;
    IdVector<SurfaceCorner, std::uint8_t> isRun(mesh_.twin.size(), 0);
    for (const SharedRun& run : runs)
      for (const SurfaceCorner h : run.edges) isRun[h] = isRun[mesh_.twin[h]] = 1;
    out.part = std::make_unique<SeamPart>(extractCharts(mesh_, s, isUnion, pulse_));
    const SeamMesh& mesh = out.part->mesh;
    Seams between;
    for (const SurfaceCorner h : out.part->wholeHalfEdge) between.push_back(isRun[h]);
    EliminationRanks ranks = out.part->ofVertices(work_.scale.eliminationRanks());
    out.joined = cutAlong(mesh, Seams(between.size(), 0), pulse_);
    out.apart = cutAlong(mesh, between, pulse_);
    out.u = LogScale(mesh, options_.pool, std::move(ranks)).solve(out.joined, {});
    if (!out.u.empty()) out.prediction = predictStretch(mesh, out.joined, out.u);
    out.before = predictStretch(mesh, out.apart, out.part->ofVertices(u_));
    return out;
  }

  const SeamMesh& meshOf(const Trial& trial) const { return trial.part ? trial.part->mesh : mesh_; }

  /// Whether joining charts along a run is worth what it stretches them.
  bool isWorth(const Trial& trial, SurfaceCorner h, const SharedRun& run, bool isSpeck) const {
    const SeamPrices& prices = options_.prices;
    const CutChartId whole = trial.joined.chartOf(h);
    const double all = trial.joined.charts[whole].area;
    const auto costOf = [&](const CutSurface& s, const Prediction& told, CutChartId c) {
      return prices.ofStretch(told.stretch[c]) * s.charts[c].area / all;
    };
    // A short piece of a crease is no reason to leave two charts hanging together.
    constexpr double kHardlyHidden = 0.5;
    if (isHinge_ && !isSpeck && run.cost < kHardlyHidden * run.length) return false;
    double more = costOf(trial.joined, trial.prediction, whole);
    for (const SurfaceCorner side : {h, meshOf(trial).twin[h]})
      more -= costOf(trial.apart, trial.before, trial.apart.chartOf(side));
    return more <= run.cost / std::sqrt(all) + prices.chart;
  }

  /// `h`: one of the opened half-edges.
  bool keepsBounds(const Trial& trial, SurfaceCorner h, const SharedRun& run) const {
    // What is cut is cut for good reasons, so no union may come near the bound. One that is joined
    // only along a part of its seam is not stretched more than its charts are.
    constexpr double kMuch = 0.7, kNearlyAll = 0.95;
    const double ofBound = isHinge_ ? kNearlyAll : kMuch;
    const CutSurface& s = trial.joined;
    const CutChartId chart = s.chartOf(h);
    if (!s.charts[chart].isDisk() ||
        trial.prediction.stretch[chart] > 1 + ofBound * (options_.maxStretch - 1))
      return false;
    const auto outline = [&](const CutSurface& surface, CutChartId c) {
      return predictOutline(meshOf(trial), surface, c, trial.u);
    };
    const Outline whole = outline(s, chart);
    const Shape shape = measureShape(whole);
    const bool isSpeck = shape.extent <= options_.speck;
    if (!isWorth(trial, h, run, isSpeck)) return false;
    if (!shape.crossings.empty() || shape.overlap > options_.mostOverlap ||
        shape.fill < (isHinge_ || isSpeck ? kLeastFill : options_.leastFill))
      return false;
    if (isSpeck) return true;
    double room = 0;
    for (const SurfaceCorner side : {h, meshOf(trial).twin[h]})
      room += hullArea(outline(trial.apart, trial.apart.chartOf(side)));
    if (shape.extent > (isHinge_ ? longest_ : options_.longest)) return false;
    return hullArea(whole) <= (isHinge_ ? kMostRoomOfHinged : kMostRoom) * room;
  }

  std::uint32_t joinWherePossible(const std::vector<SharedRun>& runs, CutSurface apart) {
    for (const SharedRun& run : runs) mark(run, false);
    const Trial trial = tryOut(runs, std::move(apart));
    const SeamMesh& mesh = meshOf(trial);
    IdVector<CutChartId, std::uint8_t> isDone(trial.joined.charts.size(), 0);
    std::uint32_t done = 0;
    for (const SharedRun& run : runs) {
      const SurfaceCorner h = trial.inTrial(run.edges.front());
      if (!trial.u.empty() && keepsBounds(trial, h, run)) {
        ++done;
        isDone[trial.joined.chartOf(h)] = 1;
        continue;
      }
      mark(run, true);
      refuse(run);
    }
    for (const SurfaceCorner h : mesh.corners()) {
      if (!isDone[trial.joined.chartOf(h)]) continue;
      const SurfaceVertex v = mesh.vertexOfCorner[h];
      u_[trial.part ? trial.part->wholeVertex[v] : v] = trial.u[v];
    }
    return done;
  }

  const SeamWork work_;
  const SeamMesh& mesh_;
  const SeamOptions& options_;
  const Pulse pulse_{[this] { return work_.goesOn(); }};
  LogScales& u_;
  Seams& seams_;
  const double longest_;
  bool isHinge_ = false;  ///< joining along parts of runs
  IdVector<SurfaceCorner, std::uint8_t> isRefused_;
  /// By the first half-edge of a run: triangles of both charts, and edges, at the time they did not
  /// fit.
  std::map<SurfaceCorner, std::array<std::size_t, 3>> unpromising_;
};

}  // namespace

std::uint32_t mergeCharts(const SeamWork& work) { return Merger(work).run(); }

}  // namespace abflat
