#include "seam/fair_seams.h"

#include <algorithm>

#include "seam/fair_paths.h"
#include "seam/occlusion.h"
#include "seam/outline.h"
#include "seam/prediction.h"

namespace abflat {
namespace {

/// Of the bound: the rest is for taking seams back, and for what flattening adds.
constexpr double kShare = 0.8;

/// Why a chart cannot have its seams drawn so.
enum class Fault : std::uint8_t { None, Stretched, Overlapping };

class SeamFairer {
 public:
  SeamFairer(const SeamMesh& mesh, const Seams& kept, const SeamOptions& options, LogScale& scale,
             std::vector<double>& u, Seams& seams)
      : mesh_(mesh), options_(options), scale_(scale), u_(u), seams_(seams) {
    constexpr float kWidth = 0.17f;
    for (const std::uint8_t isKept : kept) width_.push_back(isKept ? 0 : kWidth);
    cost_ = mesh.cost;
    constexpr double kDiscount = 0.6;
    const std::vector<double> hidden = occlusion(mesh, pulse_);
    for (std::uint32_t h = 0; h < cost_.size(); ++h) {
      if (mesh.twin[h] == kNone) continue;
      const double share = (hidden[h / 3] + hidden[mesh.twin[h] / 3]) / 2;
      const double cost = cost_[h] - kDiscount * share * mesh.length[h];
      cost_[h] = std::max(kLeastCost * mesh.length[h], cost);
    }
  }

  bool run() {
    constexpr int kRounds = 3;
    const CutSurface before = cutAlong(mesh_, seams_, pulse_);
    const Prediction was = predictStretch(mesh_, before, u_);
    for (int left = kRounds; left > 0 && pulse_.beat(); --left) {
      Seams now = seams_;
      if (!fairPaths(mesh_, cost_, width_, now, pulse_)) return false;
      const CutSurface after = cutAlong(mesh_, now, pulse_);
      std::vector<double> u = scale_.solve(after, {});
      if (u.empty() || after.charts.size() != before.charts.size()) return false;
      const Prediction told = predictStretch(mesh_, after, u);
      const std::vector<Fault> faults = faultsOf(before, was, after, told, u);
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
  std::vector<Fault> faultsOf(const CutSurface& before, const Prediction& was,
                              const CutSurface& after, const Prediction& told,
                              const std::vector<double>& u) const {
    std::vector<Fault> out;
    for (std::uint32_t c = 0; c < after.charts.size(); ++c) {
      const std::uint32_t old = before.chartOfTriangle[after.charts[c].firstTriangle];
      if (told.stretch[c] > std::max(1 + kShare * (options_.maxStretch - 1), was.stretch[old]))
        out.push_back(Fault::Stretched);
      else if (!after.charts[c].isDisk() ||
               overlapsMore(mesh_, {after, c, u}, {before, old, u_}, options_.mostOverlap))
        out.push_back(Fault::Overlapping);
      else
        out.push_back(Fault::None);
    }
    return out;
  }

  /// Paths at faulty charts are to stay nearer to where they were: where one is stretched too much,
  /// those that left a vertex whose scale is far off now.
  void narrow(float share, const Seams& now, const CutSurface& after, const Prediction& told,
              const std::vector<Fault>& faults, const std::vector<double>& u) {
    constexpr double kFarOff = 0.05, kAsFar = 0.5;  // the latter of the farthest of the chart
    std::vector<std::uint8_t> isOnSeam(mesh_.vertexCount(), 0);
    for (std::size_t h = 0; h < now.size(); ++h)
      if (now[h]) isOnSeam[mesh_.vertexOfCorner[h]] = 1;
    std::vector<double> farthest(faults.size(), 0), shift(seams_.size(), 0);
    for (std::uint32_t h = 0; h < seams_.size(); ++h) {
      const std::uint32_t v = mesh_.vertexOfCorner[h], c = after.chartOfTriangle[h / 3];
      if (!seams_[h] || isOnSeam[v] || faults[c] != Fault::Stretched) continue;
      shift[h] = told.shift(c, u[v]);
      farthest[c] = std::max(farthest[c], shift[h]);
    }
    for (std::uint32_t h = 0; h < seams_.size(); ++h) {
      const std::uint32_t c = after.chartOfTriangle[h / 3];
      if (!seams_[h] || mesh_.twin[h] == kNone || faults[c] == Fault::None) continue;
      if (share > 0 && farthest[c] > kFarOff && shift[h] < kAsFar * farthest[c]) continue;
      const float width = std::min(width_[h], share * width_[h]);
      width_[h] = width_[mesh_.twin[h]] = width;
    }
  }

  const SeamMesh& mesh_;
  const SeamOptions& options_;
  const Pulse pulse_{[this] { return !options_.keepsOn || options_.keepsOn(); }};
  LogScale& scale_;
  std::vector<double>& u_;
  Seams& seams_;
  std::vector<double> cost_;  ///< per half-edge, as is width_: see fairPaths()
  std::vector<float> width_;
};

}  // namespace

bool fairSeams(const SeamMesh& mesh, const Seams& kept, const SeamOptions& options, LogScale& scale,
               std::vector<double>& u, Seams& seams) {
  return SeamFairer(mesh, kept, options, scale, u, seams).run();
}

}  // namespace abflat
