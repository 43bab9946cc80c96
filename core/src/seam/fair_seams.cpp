#include "seam/fair_seams.h"

#include <algorithm>

#include "seam/fair_paths.h"
#include "seam/occlusion.h"
#include "seam/outline.h"
#include "seam/prediction.h"
#include "seam/seam_value.h"
#include "seam/symmetric_seams.h"

namespace abflat {
namespace {

/// Share of the bound that may be used: the rest is for taking seams back, and for what flattening
/// adds.
constexpr double kShare = 0.8;

/// Why a chart cannot have its seams redrawn this way.
enum class Fault : std::uint8_t { None, Stretched, Overlapping };
using Faults = IdVector<CutChartId, Fault>;

class SeamFairer {
 public:
  explicit SeamFairer(const SeamWork& work)
      : work_(work), mesh_(work.mesh), u_(work.u), seams_(work.seams), cost_(mesh_.cost) {
    constexpr float kWidth = 0.17f;
    for (const std::uint8_t isKept : work.kept) width_.push_back(isKept ? 0 : kWidth);
    if (work.options.prices.unseen > 0) preferHidden(work.options.prices.unseen);
    if (work.options.mirror) keepToOneSide();
  }

  bool run() {
    constexpr int kRounds = 3;
    const CutSurface before = cutAlong(mesh_, seams_, listener_);
    const Prediction was = predictStretch(mesh_, before, u_);
    for (int left = kRounds; left > 0 && listener_.beat(); --left) {
      Seams now = seams_;
      if (!fairPaths(mesh_, cost_, width_, now, listener_)) return false;
      if (const Mirror& mirror = work_.options.mirror) now = mirrored(mesh_, mirror, now, 1);
      const CutSurface after = cutAlong(mesh_, now, listener_);
      LogScales u = work_.scale.solve(after, {});
      if (u.empty() || after.charts.size() != before.charts.size()) return false;
      const Prediction told = predictStretch(mesh_, after, u);
      const Faults faults =
          faultsOf(before, was, after, told, u, isDearer(before, was, after, told, now));
      if (std::all_of(faults.begin(), faults.end(), [](Fault f) { return f == Fault::None; })) {
        seams_ = std::move(now);
        u_ = std::move(u);
        return true;
      }
      constexpr float kNarrower = 0.4f;
      narrow(left > 2 ? kNarrower : 0, now, after, told, faults, u);
    }
    return false;
  }

 private:
  void preferHidden(double unseen) {
    const IdVector<SurfaceTriangle, double> hidden = occlusion(mesh_, listener_);
    for (const SurfaceCorner h : cost_.ids()) {
      const SurfaceCorner o = mesh_.twin[h];
      if (!o.exists()) continue;
      const double share = (hidden[triangleOf(h)] + hidden[triangleOf(o)]) / 2;
      const double cost = cost_[h] - unseen * share * mesh_.length[h];
      cost_[h] = std::max(kLeastCost * mesh_.length[h], cost);
    }
  }

  /// Seams are redrawn on one side of the plane only, and mirrored. What has no image moves freely.
  void keepToOneSide() {
    const Mirror& mirror = work_.options.mirror;
    for (const SurfaceCorner h : mesh_.corners()) {
      if (!mirror.hasImage(h)) continue;
      if (mirror.sideOf(mesh_, h) != 1) width_[h] = 0;
      if (std::min(mirror.side[mesh_.tail(h)], mirror.side[mesh_.head(h)]) < 0)
        cost_[h] = kBarredCost;
    }
  }

  /// Whether shorter seams cost more by what they stretch.
  bool isDearer(const CutSurface& before, const Prediction& was, const CutSurface& after,
                const Prediction& told, const Seams& now) const {
    const SeamPrices& prices = work_.options.prices;
    return costOfAll(mesh_, now, after, told, prices) >
           costOfAll(mesh_, seams_, before, was, prices);
  }

  Faults faultsOf(const CutSurface& before, const Prediction& was, const CutSurface& after,
                  const Prediction& told, const LogScales& u, bool isDearer) const {
    constexpr double kMore = 1e-6;
    Faults out;
    for (const CutChartId c : after.charts.ids()) {
      const CutChartId old = before.chartOfTriangle[after.charts[c].firstTriangle];
      const double most = 1 + kShare * (work_.options.maxStretch - 1);
      if (told.stretch[c] > std::max(isDearer ? 1 + kMore : most, was.stretch[old]))
        out.push_back(Fault::Stretched);
      else if (!after.charts[c].isDisk() ||
               overlapsMore(mesh_, {after, c, u}, {before, old, u_}, work_.options.mostOverlap))
        out.push_back(Fault::Overlapping);
      else
        out.push_back(Fault::None);
    }
    return out;
  }

  /// Keeps paths at faulty charts nearer to their former place. For a chart that is stretched too
  /// much, these are only the paths that left a vertex whose scale is now far off.
  void narrow(float share, const Seams& now, const CutSurface& after, const Prediction& told,
              const Faults& faults, const LogScales& u) {
    constexpr double kFarOff = 0.05, kAsFar = 0.5;  // kAsFar: relative to the farthest of the chart
    IdVector<SurfaceVertex, std::uint8_t> isOnSeam(mesh_.vertexCount(), 0);
    for (const SurfaceCorner h : now.ids())
      if (now[h]) isOnSeam[mesh_.vertexOfCorner[h]] = 1;
    IdVector<CutChartId, double> farthest(faults.size(), 0);
    IdVector<SurfaceCorner, double> shift(seams_.size(), 0);
    for (const SurfaceCorner h : seams_.ids()) {
      const SurfaceVertex v = mesh_.vertexOfCorner[h];
      const CutChartId c = after.chartOf(h);
      if (!seams_[h] || isOnSeam[v] || faults[c] != Fault::Stretched) continue;
      shift[h] = told.shift(c, u[v]);
      farthest[c] = std::max(farthest[c], shift[h]);
    }
    for (const SurfaceCorner h : seams_.ids()) {
      const CutChartId c = after.chartOf(h);
      if (!seams_[h] || !mesh_.twin[h].exists() || faults[c] == Fault::None) continue;
      if (share > 0 && farthest[c] > kFarOff && shift[h] < kAsFar * farthest[c]) continue;
      const float width = std::min(width_[h], share * width_[h]);
      width_[h] = width_[mesh_.twin[h]] = width;
    }
  }

  const SeamWork work_;
  const SeamMesh& mesh_;
  const Listener& listener_ = work_.options.listener;
  LogScales& u_;
  Seams& seams_;
  IdVector<SurfaceCorner, double> cost_;  ///< see fairPaths()
  IdVector<SurfaceCorner, float> width_;
};

}  // namespace

bool fairSeams(const SeamWork& work) { return SeamFairer(work).run(); }

}  // namespace abflat
