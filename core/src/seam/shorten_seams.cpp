#include "seam/shorten_seams.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "base/stable_order.h"
#include "seam/closed_charts.h"
#include "seam/outline.h"
#include "seam/prediction.h"
#include "seam/seam_tips.h"
#include "seam/seam_value.h"

namespace abflat {
namespace {

/// Rounds; large meshes get fewer, since the last rounds gain less than they cost.
constexpr std::size_t kFewRounds = 7, kManyRounds = 12, kTriangles = 200000;
/// Share of the remaining stretch that a round may use, since a first-order estimate tends to be
/// too low.
constexpr double kShareOfSlack = 0.8;
/// A smaller share of the bound is not worth a round.
constexpr double kLittle = 0.03;
/// The whole is left once it is this many times larger than what is not done.
constexpr std::size_t kMuchLarger = 2;
/// For a freed vertex: farther from the chart's mean, the log-scale predicts too little.
constexpr double kMostShift = 0.8;

/// The state of a chart that is being shortened.
struct Progress {
  double model = 1;     ///< ratio of the added stretch to the expected one
  double expected = 0;  ///< in this round
  std::size_t most = std::numeric_limits<std::size_t>::max();  ///< tips to shorten at a time
  std::size_t chosen = 0;                                      ///< in this round
  bool isDone = false;
};

class Shortener {
 public:
  explicit Shortener(const SeamWork& work)
      : work_(work),
        mesh_(work.mesh),
        outgoing_(outgoingHalfEdges(work.mesh)),
        u_(work.u),
        seams_(work.seams) {}

  void run(bool isSolved) {
    surface_ = cutAlong(mesh_, seams_, listener_);
    if (!isSolved) {
      LogScales u = work_.scale.solve(surface_, {});
      if (u.empty()) return;
      u_ = std::move(u);
    }
    prediction_ = predictStretch(mesh_, surface_, u_);
    progress_.resize(surface_.charts.size());
    shortenFor(std::clamp(kTriangles / mesh_.triangleCount(), kFewRounds, kManyRounds));
  }

 private:
  /// So many rounds, of which each goes on with only a part of the surface once most of it is done.
  void shortenFor(std::size_t rounds) {
    for (; rounds > 0 && listener_.tell(); --rounds) {
      if (isMostDone()) return shortenRestFor(rounds);
      if (!shorten()) return;
    }
  }

  void noteDone() {
    for (const CutChartId c : progress_.ids())
      if (!surface_.charts[c].isDisk() || !(slack(c) > kLittle * most()))
        progress_[c].isDone = true;
  }

  bool isMostDone() {
    noteDone();
    std::size_t left = 0;
    for (const CutChartId c : progress_.ids())
      if (!progress_[c].isDone) left += surface_.charts[c].triangles;
    return left > 0 && kMuchLarger * left < mesh_.triangleCount();
  }

  /// The charts that are not done, with their slits closed.
  SeamPart rest() const {
    std::vector<SurfaceTriangle> charts;
    for (const CutChartId c : progress_.ids())
      if (!progress_[c].isDone) charts.push_back(surface_.charts[c].firstTriangle);
    return extractClosed(mesh_, seams_, {}, charts);
  }

  void shortenRestFor(std::size_t rounds) {
    const SeamPart part = rest();
    LogScale scale(part.mesh, work_.options.pool, part.ofVertices(work_.scale.eliminationRanks()));
    const Seams kept = part.ofCorners(work_.kept);
    Seams seams = part.ofCorners(seams_);
    for (const SurfaceCorner h : seams.ids()) seams[h] = seams[h] && part.mesh.twin[h].exists();
    LogScales u = part.ofVertices(u_);
    Shortener other({part.mesh, kept, work_.options, scale, u, seams});
    other.takeProgress(*this, part);
    other.shortenFor(rounds);
    for (const SurfaceCorner h : seams.ids())
      if (part.mesh.twin[h].exists()) seams_[part.wholeHalfEdge[h]] = seams[h];
    part.putInto(u_, u);
  }

  /// Goes on where `whole` was, with a part of its charts, which are in the same order.
  void takeProgress(const Shortener& whole, const SeamPart& part) {
    surface_ = cutAlong(mesh_, seams_, listener_);
    prediction_ = predictStretch(mesh_, surface_, u_);
    isSolved_ = false;
    for (const Progress& p : whole.progress_)
      if (!p.isDone) progress_.push_back(p);
    for (const SurfaceVertex v : mesh_.vertices())
      if (const auto limit = whole.limit_.find(part.wholeVertex[v]); limit != whole.limit_.end())
        limit_[v] = limit->second;
  }

  /// A tip and how many of its edges are taken back.
  struct Choice {
    SeamTip tip;
    std::size_t count = 0;
  };

  void mark(const Choice& choice, bool isSeam) {
    for (std::size_t i = 0; i < choice.count; ++i) {
      const SurfaceCorner h = choice.tip.edges[i];
      seams_[h] = seams_[mesh_.twin[h]] = isSeam;
    }
  }

  /// One round; false if there is nothing left to do.
  bool shorten() {
    std::vector<Choice> choices = choose();
    if (choices.empty()) return false;
    for (const Choice& choice : choices) mark(choice, false);
    CutSurface next = cutAlong(mesh_, seams_, listener_);
    LogScales u = work_.scale.solve(next, {});
    // Charts stay the same, in the same order, as long as no seam between them has gone.
    if (u.empty() || next.charts.size() != surface_.charts.size()) {
      for (const Choice& choice : choices) mark(choice, true);
      return false;
    }
    Prediction told = predictStretch(mesh_, next, u);
    const IdVector<CutChartId, std::uint8_t> isRefused = refused(choices, next, told, u);
    settle(choices, isRefused, told);
    // Charts are independent of each other.
    for (const OpenVertex v : surface_.vertices())
      if (const CutChartId c = surface_.chartOf(v); isRefused[c]) {
        u[surface_.meshVertex[v]] = u_[surface_.meshVertex[v]];
        told.stretch[c] = prediction_.stretch[c];
        told.meanScale[c] = prediction_.meanScale[c];
      }
    u_ = std::move(u);
    prediction_ = std::move(told);
    isSolved_ = std::find(isRefused.begin(), isRefused.end(), 1) == isRefused.end();
    surface_ = isSolved_ ? std::move(next) : cutAlong(mesh_, seams_, listener_);
    return true;
  }

  /// The factor has to match the surface as it is now.
  bool solveAsItIs() {
    isSolved_ = isSolved_ || !work_.scale.solve(surface_, {}).empty();
    return isSolved_;
  }

  std::vector<Choice> choose() {
    noteDone();
    IdVector<CutChartId, std::uint8_t> isWanted;
    for (const Progress& p : progress_) isWanted.push_back(!p.isDone);
    if (std::find(isWanted.begin(), isWanted.end(), 1) == isWanted.end() || !solveAsItIs())
      return {};
    IdVector<CutChartId, std::vector<Choice>> of(progress_.size());
    for (SeamTip& tip : findTips({mesh_, seams_, work_.kept, u_, outgoing_}, surface_, prediction_,
                                 isWanted, work_.scale)) {
      const auto limit = limit_.find(tip.vertex(mesh_));
      if (limit != limit_.end()) tip.edges.resize(std::min(tip.edges.size(), limit->second));
      std::vector<Choice>& own = of[tip.chart];
      if (!tip.edges.empty()) own.push_back({std::move(tip), 0});
    }
    std::vector<Choice> out;
    for (const CutChartId c : of.ids()) {
      chooseIn(c, of[c]);
      Progress& p = progress_[c];
      p.expected = 0;
      p.chosen = 0;
      for (Choice& choice : of[c]) {
        if (choice.count == 0) continue;
        ++p.chosen;
        p.expected += p.model * choice.tip.stretch[choice.count - 1];
        out.push_back(std::move(choice));
      }
      p.isDone = p.isDone || p.chosen == 0;
    }
    return out;
  }

  /// From each tip, takes as much as costs at most a certain stretch for its length. This rate is
  /// the same for all tips, chosen so that together they use up the slack.
  void chooseIn(CutChartId c, std::vector<Choice>& choices) const {
    const double budget = kShareOfSlack * slack(c) / progress_[c].model;
    const auto takeAt = [&](double rate) {
      double sum = 0;
      for (Choice& choice : choices) {
        const SeamTip& tip = choice.tip;
        choice.count = tip.edges.size();
        while (choice.count > 0 &&
               (tip.stretch[choice.count - 1] > rate * tip.length[choice.count - 1] ||
                !isWorth(c, tip, choice.count)))
          --choice.count;
        if (choice.count > 0) sum += tip.stretch[choice.count - 1];
      }
      return sum;
    };
    double low = 0, high = 1;
    constexpr double kHighest = 1e9;
    while (high < kHighest && takeAt(high) <= budget) high *= 4;
    constexpr int kHalvings = 40;
    for (int i = 0; i < kHalvings; ++i) {
      const double rate = (low + high) / 2;
      (takeAt(rate) <= budget ? low : high) = rate;
    }
    takeAt(low);
    keepLongest(progress_[c].most, choices);
  }

  /// What it costs to stretch a chart more than now.
  double priceOf(CutChartId c, double stretch) const {
    const SeamPrices& prices = work_.options.prices;
    return (prices.ofStretch(stretch) - prices.ofStretch(prediction_.stretch[c])) *
           std::sqrt(surface_.charts[c].area);
  }

  /// Whether it is better not to have the first `count` edges of a tip.
  bool isWorth(CutChartId c, const SeamTip& tip, std::size_t count) const {
    const double stretch = prediction_.stretch[c] + progress_[c].model * tip.stretch[count - 1];
    return priceOf(c, stretch) <= tip.length[count - 1];
  }

  /// Keeps only the `most` longest choices, after more of them did not work together.
  static void keepLongest(std::size_t most, std::vector<Choice>& choices) {
    const auto length = [&](std::uint32_t i) {
      const Choice& x = choices[i];
      return x.count > 0 ? x.tip.length[x.count - 1] : 0;
    };
    const std::vector<std::uint32_t> order = stableOrder(
        choices.size(), [&](std::uint32_t a, std::uint32_t b) { return length(a) > length(b); });
    for (std::size_t i = most; i < order.size(); ++i) choices[order[i]].count = 0;
  }

  double most() const { return work_.options.maxStretch - 1; }
  double slack(CutChartId c) const { return work_.options.maxStretch - prediction_.stretch[c]; }

  /// Charts that exceed their bounds.
  IdVector<CutChartId, std::uint8_t> refused(const std::vector<Choice>& choices,
                                             const CutSurface& next, const Prediction& told,
                                             const LogScales& u) const {
    IdVector<CutChartId, std::uint8_t> isChanged(progress_.size(), 0), out(progress_.size(), 0);
    IdVector<CutChartId, double> gain(progress_.size(), 0);
    for (const Choice& choice : choices) {
      const CutChartId c = choice.tip.chart;
      isChanged[c] = 1;
      if (choice.count > 0) gain[c] += choice.tip.length[choice.count - 1];
      for (std::size_t i = 0; i < choice.count; ++i)
        if (told.shift(c, u[mesh_.vertexOfCorner[choice.tip.edges[i]]]) > kMostShift) out[c] = 1;
    }
    for (const CutChartId c : out.ids())
      if (isChanged[c] &&
          (told.stretch[c] > work_.options.maxStretch || priceOf(c, told.stretch[c]) > gain[c] ||
           !next.charts[c].isDisk() ||
           overlapsMore(mesh_, {next, c, u}, {surface_, c, u_}, work_.options.mostOverlap)))
        out[c] = 1;
    return out;
  }

  /// Undoes what was refused, and learns from all results.
  void settle(const std::vector<Choice>& choices,
              const IdVector<CutChartId, std::uint8_t>& isRefused, const Prediction& told) {
    for (const Choice& choice : choices) {
      const CutChartId c = choice.tip.chart;
      if (!isRefused[c]) continue;
      mark(choice, true);
      if (progress_[c].chosen == 1) limit_[choice.tip.vertex(mesh_)] = choice.count / 2;
    }
    constexpr double kLeast = 0.7, kMost = 3;
    for (const CutChartId c : progress_.ids()) {
      Progress& p = progress_[c];
      if (p.isDone) continue;
      if (isRefused[c])
        p.most = std::max<std::size_t>(p.chosen / 2, 1);
      else if (p.expected > 0)
        p.model *=
            std::clamp((told.stretch[c] - prediction_.stretch[c]) / p.expected, kLeast, kMost);
    }
  }

  const SeamWork work_;
  const SeamMesh& mesh_;
  const Listener& listener_ = work_.options.listener;
  const IdVector<SurfaceVertex, SurfaceCorner> outgoing_;
  LogScales& u_;
  Seams& seams_;
  CutSurface surface_;
  Prediction prediction_;
  bool isSolved_ = true;  ///< for the surface
  IdVector<CutChartId, Progress> progress_;
  /// For the vertex that a tip ends at, how many edges may be taken back, as far as known.
  std::map<SurfaceVertex, std::size_t> limit_;
};

}  // namespace

void shortenSeams(const SeamWork& work, bool isSolved) { Shortener(work).run(isSolved); }

}  // namespace abflat
