#include "seam/merge_charts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "base/stable_order.h"
#include "seam/merge_trial.h"
#include "seam/run_hinges.h"
#include "seam/run_images.h"
#include "seam/seam_value.h"

namespace abflat {
namespace {

/// How much larger the convex hull of a union may be than the hulls of its charts together. Hulls
/// predict the room needed for packing.
constexpr double kMostRoom = 1.05;

/// Limits for a union that is joined along only a part of its seam: its hull as above, the share of
/// its hull that it fills, and its extent. The latter is relative to the root of the whole area,
/// so that the union fits into a well-filled square from corner to corner.
constexpr double kMostRoomOfHinged = 1.4, kLeastFill = 0.3, kLongest = 1.9;

/// Relative to its length, the cost of a seam that is not hidden.
constexpr double kHardlyHidden = 0.5;

/// Limits for charts that are joined together with their images, which leaves fewer ways to join
/// them, or with their own images: nothing else takes away a seam in the plane of symmetry.
constexpr double kMostRoomOfImages = 1.25, kOfBoundInPlane = 1;

using ChartOutlines = IdVector<CutChartId, Outline>;

class Merger {
 public:
  explicit Merger(const SeamWork& work)
      : work_(work),
        mesh_(work.mesh),
        options_(work.options),
        images_(work.mesh, work.options.mirror),
        u_(work.u),
        seams_(work.seams),
        longest_(std::min(options_.longest, kLongest * std::sqrt(work.area))),
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
    // Runs that share charts with longer ones get a turn, unless that takes long.
    constexpr std::size_t kLarge = 200000;  // triangles
    const int mostFruitless = mesh_.triangleCount() > kLarge ? 1 : 3;
    std::uint32_t done = 0;
    int fruitless = 0;
    while (listener_.tell()) {
      if (!apart_) apart_ = cutAlong(mesh_, seams_, listener_);
      const std::vector<RunsTogether> runs = matching(*apart_);
      if (runs.empty()) break;
      const std::uint32_t now = joinWherePossible(runs);
      fruitless = now == 0 ? fruitless + 1 : 0;
      if (fruitless == mostFruitless && !isHinge_) break;
      done += now;
    }
    return done;
  }

  /// Whether the charts' separate layouts fit together.
  bool isPromising(const CutSurface& s, const ChartOutlines& outlines, const SharedRun& run) const {
    const OutlinePairs pairs = pairsOf(mesh_, s, run, outlines[run.a]);
    const Outline &a = outlines[run.a], &b = outlines[run.b];
    if (!isHinge_ && hullTogether(a, b, pairs) <= mostRoom(run)) return true;
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

  double mostRoom(const SharedRun& run) const {
    // In plain sight between a chart and its image.
    if (images_.isInPlane(run) && !(run.cost < kHardlyHidden * run.length))
      return kMostRoomOfImages;
    if (isHinge_) return kMostRoomOfHinged;
    return images_.has(run) && !images_.isOwn(run) ? kMostRoomOfImages : kMostRoom;
  }

  /// Runs with their images; what costs most comes first.
  std::vector<RunsTogether> candidates(const CutSurface& s) const {
    std::vector<SharedRun> runs = sharedRuns(mesh_, work_.kept, s);
    sortStably(runs, [](const SharedRun& x, const SharedRun& y) {
      return x.cost != y.cost ? x.cost > y.cost : x.edges.front() < y.edges.front();
    });
    if (isHinge_) runs = hingesOf(mesh_, images_, s, runs);
    std::vector<RunsTogether> out;
    for (const SharedRun& run : runs) {
      if (isRefused(run)) continue;
      RunsTogether together = images_.together(s, work_.kept, run);
      if (!together.empty()) out.push_back(std::move(together));
    }
    // With its image a run saves twice as much.
    const auto saved = [](const RunsTogether& x) {
      return x.front().cost * static_cast<double>(x.size());
    };
    if (options_.mirror && !isHinge_)
      sortStably(out,
                 [&](const RunsTogether& x, const RunsTogether& y) { return saved(x) > saved(y); });
    return out;
  }

  /// The promising ones of them, no two of which share a chart.
  std::vector<RunsTogether> matching(const CutSurface& s) {
    ChartOutlines outlines(s.charts.size());
    IdVector<CutChartId, std::uint8_t> isUsed(s.charts.size(), 0);
    std::vector<RunsTogether> out;
    for (RunsTogether& together : candidates(s)) {
      const bool isPossible =
          std::all_of(together.begin(), together.end(), [&](const SharedRun& run) {
            return !isUsed[run.a] && !isUsed[run.b] && !isRefused(run) &&
                   stillPromises(s, outlines, run);
          });
      if (!isPossible) continue;
      for (const SharedRun& each : together) isUsed[each.a] = isUsed[each.b] = 1;
      out.push_back(std::move(together));
    }
    return out;
  }

  void mark(const SharedRun& run, bool isSeam) {
    for (const SurfaceCorner h : run.edges) seams_[h] = seams_[mesh_.twin[h]] = isSeam;
  }

  void refuse(const SharedRun& run) {
    for (const SurfaceCorner h : run.edges) isRefused_[h] = isRefused_[mesh_.twin[h]] = 1;
  }

  /// Whether joining charts along runs is worth what it stretches them.
  bool isWorth(const MergeTrial& trial, const RunsTogether& runs) const {
    const SeamPrices& prices = options_.prices;
    const CutChartId whole = trial.joinedAt(runs.front());
    const double all = trial.joined().charts[whole].area;
    const auto costOf = [&](double stretch, double area) {
      return prices.ofStretch(stretch) * area / all;
    };
    double more = costOf(trial.stretchOf(whole), all);
    for (const CutChartId part : trial.partsOf(runs))
      more -= costOf(trial.stretchApart(part), trial.apart().charts[part].area);
    for (const SharedRun& run : runs) {
      // A short piece of a crease is no reason to leave two charts hanging together.
      if (isHinge_ && run.cost < kHardlyHidden * run.length) return false;
      more -= run.cost / std::sqrt(all) + prices.chart;
    }
    return more <= 0;
  }

  /// Of runs that join charts into a single one.
  bool keepsBounds(const MergeTrial& trial, const RunsTogether& runs) const {
    // What is cut is cut for good reasons, so no union may come near the bound. One that is joined
    // only along a part of its seam is not stretched more than its charts are.
    constexpr double kMuch = 0.7, kNearlyAll = 0.95;
    const double ofBound = images_.isInPlane(runs.front()) ? kOfBoundInPlane
                           : isHinge_                      ? kNearlyAll
                                                           : kMuch;
    const CutSurface& s = trial.joined();
    const CutChartId chart = trial.joinedAt(runs.front());
    if (!s.charts[chart].isDisk() ||
        trial.stretchOf(chart) > 1 + ofBound * (options_.maxStretch - 1))
      return false;
    const auto outline = [&](const CutSurface& surface, CutChartId c) {
      return predictOutline(trial.mesh(), surface, c, trial.scale());
    };
    const Outline whole = outline(s, chart);
    const Shape shape = measureShape(whole);
    const bool isSpeck = shape.extent <= options_.speck;
    if (!isSpeck && !isWorth(trial, runs)) return false;
    if (!shape.crossings.empty() || shape.overlap > options_.mostOverlap ||
        shape.fill < (isHinge_ || isSpeck ? kLeastFill : options_.leastFill))
      return false;
    if (isSpeck) return true;
    double room = 0;
    for (const CutChartId part : trial.partsOf(runs))
      room += hullArea(outline(trial.apart(), part));
    if (shape.extent > (isHinge_ ? longest_ : options_.longest)) return false;
    return hullArea(whole) <= mostRoom(runs.front()) * room;
  }

  bool isPossible(const MergeTrial& trial, const RunsTogether& runs) const {
    if (trial.scale().empty()) return false;
    if (runs.size() == 1 || trial.joinedAt(runs.front()) == trial.joinedAt(runs.back()))
      return keepsBounds(trial, runs);
    return std::all_of(runs.begin(), runs.end(),
                       [&](const SharedRun& run) { return keepsBounds(trial, {run}); });
  }

  std::uint32_t joinWherePossible(const std::vector<RunsTogether>& all) {
    for (const RunsTogether& together : all)
      for (const SharedRun& run : together) mark(run, false);
    const MergeTrial trial(work_, all, apart_, listener_);
    const SeamMesh& mesh = trial.mesh();
    IdVector<CutChartId, std::uint8_t> isDone(trial.joined().charts.size(), 0);
    std::uint32_t done = 0;
    for (const RunsTogether& together : all) {
      const bool isJoined = isPossible(trial, together);
      for (const SharedRun& run : together) {
        if (isJoined) {
          ++done;
          apart_.reset();
          isDone[trial.joinedAt(run)] = 1;
        } else {
          mark(run, true);
          refuse(run);
        }
      }
    }
    for (const SurfaceCorner h : mesh.corners()) {
      if (!isDone[trial.joined().chartOf(h)]) continue;
      const SurfaceVertex v = mesh.vertexOfCorner[h];
      u_[trial.inWhole(v)] = trial.scale()[v];
    }
    return done;
  }

  const SeamWork work_;
  const SeamMesh& mesh_;
  const SeamOptions& options_;
  const RunImages images_;
  const Listener& listener_ = work_.options.listener;
  LogScales& u_;
  Seams& seams_;
  const double longest_;
  std::optional<CutSurface> apart_;  ///< along the seams as they are, if that is known
  bool isHinge_ = false;             ///< joining along parts of runs
  IdVector<SurfaceCorner, std::uint8_t> isRefused_;
  /// By the first half-edge of a run: triangles of both charts, and edges, at the time they did not
  /// fit.
  std::map<SurfaceCorner, std::array<std::size_t, 3>> unpromising_;
};

}  // namespace

std::uint32_t mergeCharts(const SeamWork& work) { return Merger(work).run(); }

}  // namespace abflat
