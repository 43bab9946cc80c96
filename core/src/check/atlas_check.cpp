#include "check/atlas_check.h"

#include <algorithm>
#include <cmath>

#include "base/stable_order.h"
#include "check/boundary_curves.h"
#include "exact/orientation.h"
#include "exact/overlap.h"

namespace abflat {
namespace {

/// After each round of the overlap search, the charts found are left out and the rest is searched
/// again.
constexpr int kMostShrinks = 50;

struct ChartBox {
  double low[2] = {HUGE_VAL, HUGE_VAL}, high[2] = {-HUGE_VAL, -HUGE_VAL};
  bool isFinite = true;

  void add(const double* p) {
    for (std::size_t d = 0; d < 2; ++d) {
      isFinite = isFinite && std::isfinite(p[d]);
      low[d] = std::min(low[d], p[d]);
      high[d] = std::max(high[d], p[d]);
    }
  }

  /// Whether the box lies within the tile that contains its centre.
  bool isInTile(std::uint32_t tiles, double lowestV) const {
    if (!isFinite) return false;
    const double u = std::floor((low[0] + high[0]) / 2);
    const double v = std::floor((low[1] + high[1]) / 2), row = v - lowestV;
    return u >= 0 && u <= 9 && row >= 0 && 10 * row + u < tiles && low[0] >= u && low[1] >= v &&
           high[0] <= u + 1 && high[1] <= v + 1;
  }
};

class AtlasChecker {
 public:
  explicit AtlasChecker(const WrittenAtlas& atlas)
      : atlas_(atlas), isWanted_(atlas.isLeftOut.size()) {
    for (std::size_t c = 0; c < isWanted_.size(); ++c) isWanted_[c] = !atlas.isLeftOut[c];
  }

  std::vector<ChartDefect> run() {
    checkTriangles();
    for (std::size_t c = 0; c < atlas_.stacked.size(); ++c)
      if (isOnChecked(c)) isWanted_[c] = 0;
    const bool mayTouch =
        std::find(atlas_.mayTouch.begin(), atlas_.mayTouch.end(), 1) != atlas_.mayTouch.end();
    for (int round = 0; round < kMostShrinks; ++round)
      if (!(mayTouch ? findPair() : findPairOfCurves())) break;
    reportStacked();
    sortStably(out_, [](const ChartDefect& a, const ChartDefect& b) { return a.chart < b.chart; });
    return std::move(out_);
  }

 private:
  const double* at(std::size_t t, std::size_t k) const {
    return &atlas_.uv[2 * std::size_t{atlas_.triangles[3 * t + k]}];
  }
  bool isEmpty(std::size_t t) const {
    const std::uint32_t* v = &atlas_.triangles[3 * t];
    return v[0] == v[1] || v[1] == v[2] || v[2] == v[0];
  }
  bool isChecked(std::size_t t) const {
    return atlas_.chartOf[t] < isWanted_.size() && isWanted_[atlas_.chartOf[t]];
  }

  /// Whether a chart lies on one that is compared with all others for it.
  bool isOnChecked(std::size_t chart) const {
    const std::uint32_t below = atlas_.stacked[chart].on;
    return below != kOnNone && !atlas_.isLeftOut[below];
  }

  bool isMirrored(std::uint32_t chart) const {
    return chart < atlas_.stacked.size() && atlas_.stacked[chart].isMirrored;
  }

  void checkTriangles() {
    std::vector<ChartBox> boxes(isWanted_.size());
    std::vector<std::size_t> flipped(isWanted_.size(), 0);
    for (std::size_t t = 0; t < atlas_.chartOf.size(); ++t) {
      if (!isChecked(t) || isEmpty(t)) continue;
      for (std::size_t k = 0; k < 3; ++k) boxes[atlas_.chartOf[t]].add(at(t, k));
      if (!boxes[atlas_.chartOf[t]].isFinite) continue;
      const int sign =
          orientation(at(t, 0), at(t, 1), at(t, 2)) * (isMirrored(atlas_.chartOf[t]) ? -1 : 1);
      if (sign < 0 || (sign == 0 && atlas_.hasArea(t))) ++flipped[atlas_.chartOf[t]];
    }
    for (std::uint32_t c = 0; c < boxes.size(); ++c) {
      if (flipped[c] > 0) report({c, ChartDefect::Flipped, flipped[c], kNoOther});
      const bool isUsed = boxes[c].low[0] <= boxes[c].high[0];
      if (isUsed && !boxes[c].isInTile(atlas_.tiles, atlas_.lowestV))
        report({c, ChartDefect::Outside, 0, kNoOther});
    }
  }

  /// The chart is not checked again.
  void report(const ChartDefect& defect) {
    out_.push_back(defect);
    isWanted_[defect.chart] = 0;
  }

  /// What is wrong with a chart is wrong with all that lie on it.
  void reportStacked() {
    std::vector<std::size_t> defectOf(isWanted_.size(), out_.size());
    for (std::size_t i = out_.size(); i-- > 0;) defectOf[out_[i].chart] = i;
    std::vector<ChartDefect> more;
    for (std::uint32_t c = 0; c < atlas_.stacked.size(); ++c) {
      const std::uint32_t below = atlas_.stacked[c].on;
      if (below == kOnNone || atlas_.isLeftOut[c] || defectOf[c] < out_.size() ||
          defectOf[below] == out_.size())
        continue;
      const ChartDefect& defect = out_[defectOf[below]];
      more.push_back({c, defect.kind, defect.triangles, defect.other == below ? c : defect.other});
    }
    out_.insert(out_.end(), more.begin(), more.end());
  }

  void reportPair(std::uint32_t a, std::uint32_t b) {
    report({a, ChartDefect::Overlaps, 0, b});
    if (a != b) report({b, ChartDefect::Overlaps, 0, a});
  }

  /// Looks for charts that overlap or touch, by their boundaries; true if any were found.
  bool findPairOfCurves() {
    const BoundaryCurves found =
        boundaryCurves(atlas_.uv, atlas_.triangles, atlas_.chartOf, isWanted_);
    for (const std::uint32_t chart : found.broken) reportPair(chart, chart);
    if (!found.broken.empty()) return true;
    const auto wrong = findWrongCover(found.curves);
    if (!wrong) return found.arePinched && findPair();
    const std::vector<std::uint32_t>& ends = found.curves.ends;
    const auto chartAt = [&](std::uint32_t point) {
      return found.chart[static_cast<std::size_t>(
          std::upper_bound(ends.begin(), ends.end(), point) - ends.begin())];
    };
    reportPair(chartAt((*wrong)[0]), chartAt((*wrong)[1]));
    return true;
  }

  /// As above, but by triangles, for when some charts may touch each other or themselves.
  bool findPair() {
    std::vector<double> uv;
    std::vector<std::uint32_t> chart;
    for (std::size_t t = 0; t < atlas_.chartOf.size(); ++t) {
      if (!isChecked(t)) continue;
      for (std::size_t k = 0; k < 3; ++k) uv.insert(uv.end(), at(t, k), at(t, k) + 2);
      chart.push_back(atlas_.chartOf[t]);
    }
    const auto pair = findOverlap(uv);
    if (!pair) return false;
    reportPair(chart[(*pair)[0]], chart[(*pair)[1]]);
    return true;
  }

  const WrittenAtlas& atlas_;
  std::vector<std::uint8_t> isWanted_;  ///< per chart
  std::vector<ChartDefect> out_;
};

}  // namespace

std::vector<ChartDefect> checkAtlas(const WrittenAtlas& atlas) { return AtlasChecker(atlas).run(); }

}  // namespace abflat
