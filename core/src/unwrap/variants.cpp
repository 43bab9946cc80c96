#include "unwrap/variants.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "seam/occlusion.h"
#include "seam/vary_costs.h"
#include "unwrap/blocks.h"
#include "unwrap/pieces.h"
#include "unwrap/right_angled.h"
#include "unwrap/stretch.h"

namespace abflat {
namespace {

/// What costs hardly less is as good, so that it is not rounding that decides.
constexpr double kClearly = 1 - 1e-6;

Seams givenSeams(const OpenSurface& open) {
  Seams out(open.mesh.twin.size(), 0);
  // Where the mesh is open along them, the twin is that of a hole's filling, if there is one.
  for (const SurfaceCorner h : open.given.ids()) out[h] = open.given[h] && open.mesh.isOnSurface(h);
  return out;
}

/// A cut surface and what is known of its components, which given seams separate.
class CutValue {
 public:
  explicit CutValue(const OpenSurface& open)
      : mesh_(open.mesh),
        whole_(cutAlong(mesh_, givenSeams(open))),
        parts_(whole_.charts.size(), {}) {}
  CutValue(const FlatCut& cut, const UnwrapOptionValues& options) : CutValue(cut.open) {
    addCharts(cut.charts, options);
    findBlocks();
  }

  /// Where seams are hidden they are cheaper; where their cost counts, so does their length.
  void addSeams(FlatCut& cut, SeamCosts costs) {
    constexpr double kLength = 0.3, kUnseen = 0.6, kInFlat = 2;
    const bool isSight = costs == SeamCosts::Sight;
    if (isSight && cut.hidden.empty()) cut.hidden = occlusion(mesh_);
    const double ofLength = isSight ? kLength : 0;
    for (const SurfaceCorner h : cut.open.seams.ids()) {
      if (!cut.open.seams[h] || !mesh_.isOnSurface(h)) continue;
      const CutChartId c = whole_.chartOf(h);
      Part& part = parts_[c];
      const double unseen = isSight ? kUnseen * cut.hidden[triangleOf(h)] : 0;
      part.cost += (mesh_.cost[h] + ofLength * mesh_.length[h]) * (1 - unseen) /
                   (2 * std::sqrt(whole_.charts[c].area));
      part.length += mesh_.length[h];
      if (mesh_.plainCost(h) > kInFlat * mesh_.length[h]) part.inFlat += mesh_.length[h];
    }
  }

  const CutSurface& whole() const { return whole_; }
  /// What seams, charts and their stretch cost, relative to a component's own size. Warped blocks
  /// cost more: their faces should lie as they are unless that takes many seams.
  double cost(CutChartId part) const {
    constexpr double kWarped = 1.6;
    return (isWarped(part) ? kWarped : 1) * parts_[part].cost;
  }
  /// Where a component nearly unrolls, its creases say where it is cut best.
  bool unrolls(CutChartId part) const { return parts_[part].beyond <= 3e-4; }
  /// Whether a component has clearly better seams than another that nearly unrolls: it does so as
  /// well, with clearly shorter ones, but neither by cuts through flat faces nor for many right
  /// angles.
  bool unrollsBetter(CutChartId part, const CutValue& other) const {
    const Part &now = parts_[part], &before = other.parts_[part];
    return unrolls(part) && now.cost < before.cost && isClearlyBetter(now, before);
  }
  bool isWarped(CutChartId part) const { return parts_[part].isOfBlocks && !unrolls(part); }
  bool hasWarped() const {
    for (const CutChartId c : parts_.ids())
      if (isWarped(c)) return true;
    return false;
  }
  bool unrolls() const {
    for (const CutChartId c : parts_.ids())
      if (!unrolls(c)) return false;
    return true;
  }
  /// The same of all components together, which come out as cheap as `most` times.
  bool unrollsBetter(const CutValue& other, double most) const {
    return unrolls() && total() < most * other.total() &&
           isClearlyBetter(allParts(), other.allParts());
  }
  double total() const {
    double sum = 0;
    for (const CutChartId c : parts_.ids()) sum += cost(c) * std::sqrt(whole_.charts[c].area);
    return sum;
  }

 private:
  struct Part {
    double cost = 0;
    double length = 0;  ///< of seams, counted on both sides
    double inFlat = 0;  ///< the part of it in flat faces
    double beyond = 0;  ///< beyond 1, of the mean stretch
    RightAngled outline;
    bool isOfBlocks = false;  ///< only known where some component does not unroll
  };

  static bool isClearlyBetter(const Part& now, const Part& before) {
    constexpr double kClearlyLess = 0.98, kRounding = 1e-6;
    constexpr double kOfLength = 0.25;  // what less of it is worth in right angles
    const double less = 1 - now.length / before.length;
    return now.length < kClearlyLess * before.length && now.inFlat <= before.inFlat + kRounding &&
           now.outline.share() > before.outline.share() - kOfLength * less;
  }

  Part allParts() const {
    Part out;
    for (const Part& part : parts_) {
      out.length += part.length;
      out.inFlat += part.inFlat;
      out.outline += part.outline;
    }
    return out;
  }

  void addCharts(const LaidCharts& charts, const UnwrapOptionValues& options) {
    constexpr double kChart = 0.1, kStretch = 5, kBad = 10;
    for (const ChartId i : charts.set.ids()) {
      const FlatChart& flat = charts.flat[i];
      const double stretch = flat.distortion.symmetricDirichlet;
      const bool isBad = !flat.problem.empty() || stretchOf(flat.distortion, charts.set.leewayOf(i),
                                                            options) > options.maxStretch;
      double area = 0;
      for (const SurfaceTriangle f : charts.set.topology(i).triangles) area += mesh_.area[f];
      const CutChartId c = whole_.chartOfTriangle[charts.set.topology(i).triangles.front()];
      const double share = area / whole_.charts[c].area;
      Part& part = parts_[c];
      part.cost +=
          kChart + share * (kStretch * std::max(0.0, stretch - 1) / charts.set.leewayOf(i) +
                            (isBad ? kBad : 0));
      if (flat.problem.empty()) part.outline += rightAngled(charts.set.topology(i), flat.unpacked);
      part.beyond += share * (isBad ? HUGE_VAL : stretch - 1);
    }
  }

  void findBlocks() {
    if (unrolls()) return;
    const IdVector<CutChartId, std::uint8_t> isOfBlocks = areBlocks(mesh_, whole_);
    for (const CutChartId c : parts_.ids()) parts_[c].isOfBlocks = isOfBlocks[c];
  }

  const SeamMesh& mesh_;
  const CutSurface whole_;
  IdVector<CutChartId, Part> parts_;
};

CutValue valueOf(FlatCut& cut, const UnwrapOptionValues& options) {
  CutValue out(cut, options);
  out.addSeams(cut, options.seamCosts);
  return out;
}

template <class Id, class T>
bool isEqual(const IdVector<Id, T>& a, const IdVector<Id, T>& b) {
  return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin());
}

/// Borders of plates are given seams of one of them, perhaps.
bool haveSameParts(const OpenSurface& a, const OpenSurface& b) {
  return isEqual(a.mesh.twin, b.mesh.twin) &&
         isEqual(a.mesh.vertexOfCorner, b.mesh.vertexOfCorner) && isEqual(a.given, b.given);
}

bool areComparedAsAWhole(const OpenSurface& best, const OpenSurface& other) {
  return best.mirror || other.mirror || !haveSameParts(best, other);
}

/// Symmetric seams may cost a little more.
bool isBetterAsAWhole(const CutValue& now, const CutValue& then, const OpenSurface& best,
                      const OpenSurface& other) {
  constexpr double kSymmetric = 1.1;
  const bool was = static_cast<bool>(best.mirror), is = static_cast<bool>(other.mirror);
  const double most = is == was ? kClearly : is ? kSymmetric : 1 / kSymmetric;
  if (now.unrolls()) return then.unrollsBetter(now, most);
  return then.total() < most * now.total();
}

void takeSeams(const CutSurface& whole, const IdVector<CutChartId, std::uint8_t>& isTaken,
               OpenSurface& to, OpenSurface& from) {
  for (OpenSurface* open : {&to, &from}) {
    open->seams.resize(open->mesh.twin.size(), 0);
    open->found.resize(open->mesh.twin.size(), 0);
    open->mesh.excess.resize(open->mesh.triangleCount(), 1);
  }
  for (const SurfaceCorner h : to.mesh.corners()) {
    if (!isTaken[whole.chartOf(h)]) continue;
    to.seams[h] = from.seams[h];
    to.found[h] = from.found[h];
    to.mesh.excess[triangleOf(h)] = from.mesh.excess[triangleOf(h)];
    const SurfaceVertex v = to.mesh.tail(h);
    to.scale[v] = from.scale[v];
    to.foundScale[v] = from.foundScale[v];
  }
}

}  // namespace

std::vector<SeamVariant> variantsWorth(std::size_t triangles, double inFront, bool hasMask) {
  constexpr std::size_t kTriangles = 20000;        // about half a second
  constexpr std::size_t kMostWithFront = 120'000;  // about three seconds for each
  constexpr double kLeastInFront = 0.02;           // less is not what people look at
  std::vector<SeamVariant> out;
  if (hasMask && triangles <= kMostWithFront) {
    out.emplace_back();
    out.back().isUncut = true;
  }
  if (inFront >= kLeastInFront && triangles <= kMostWithFront)
    for (int k = 1; k <= kFrontVariants; ++k) out.push_back({kCostVariants + k});
  const std::size_t others = triangles == 0 ? 0 : kTriangles / triangles;
  if (others > 0) out.push_back({0, SeamBound::Tighter});
  if (others > 0) out.push_back({0, SeamBound::Exact});
  for (int k = 1; k <= static_cast<int>(std::min<std::size_t>(others, kCostVariants)); ++k)
    out.push_back({k});
  return out;
}

bool hasMask(const OpenSurface& open) {
  constexpr double kMostly = 0.5;
  const SeamMesh& mesh = open.mesh;
  if (mesh.front.empty()) return false;
  const CutSurface whole = cutAlong(mesh, givenSeams(open));
  IdVector<CutChartId, double> inFront(whole.charts.size(), 0);
  for (const SurfaceTriangle f : mesh.triangles())
    inFront[whole.chartOfTriangle[f]] += mesh.area[f] * mesh.frontAt(f);
  for (const CutChartId c : whole.charts.ids())
    if (whole.charts[c].isDisk() && inFront[c] > kMostly * whole.charts[c].area) return true;
  return false;
}

double costOf(const UnwrapOptionValues& options, FlatCut& cut) {
  return valueOf(cut, options).total();
}

bool isExactWorth(const UnwrapOptionValues& options, const FlatCut& cut) {
  const CutValue value(cut, options);
  return value.unrolls() || value.hasWarped();
}

bool isSettled(const UnwrapOptionValues& options, const FlatCut& cut) {
  return CutValue(cut, options).unrolls();
}

bool isCutInFront(const OpenSurface& open) {
  constexpr double kSeen = 0.02;  // of the root of the area
  const SeamMesh& mesh = open.mesh;
  if (mesh.front.empty()) return false;
  double length = 0;
  for (const SurfaceCorner h : open.seams.ids())
    if (open.seams[h] && mesh.isOnSurface(h) && mesh.twin[h].exists())
      length += mesh.length[h] * mesh.front[triangleOf(h)] / 2;
  return length > kSeen * std::sqrt(mesh.totalArea());
}

bool isHopeless(const UnwrapOptionValues& options, FlatCut& best, FlatCut& other) {
  const CutValue now = valueOf(best, options);
  CutValue then(other.open);
  then.addSeams(other, options.seamCosts);
  if (areComparedAsAWhole(best.open, other.open))
    return !isBetterAsAWhole(now, then, best.open, other.open);
  for (const CutChartId c : now.whole().charts.ids())
    if (then.cost(c) < kClearly * now.cost(c)) return false;
  return true;
}

bool takeBetter(const WeldedMesh& welded, const UnwrapOptionValues& options, FlatCut& best,
                FlatCut& other) {
  const CutValue now = valueOf(best, options), then = valueOf(other, options);
  if (areComparedAsAWhole(best.open, other.open)) {
    if (!isBetterAsAWhole(now, then, best.open, other.open)) return false;
    best = std::move(other);
    return true;
  }
  IdVector<CutChartId, std::uint8_t> isBetter;
  for (const CutChartId c : now.whole().charts.ids())
    isBetter.push_back(now.unrolls(c) ? then.unrollsBetter(c, now)
                                      : then.cost(c) < kClearly * now.cost(c));
  if (std::find(isBetter.begin(), isBetter.end(), 1) == isBetter.end()) return false;
  takeSeams(now.whole(), isBetter, best.open, other.open);
  LaidCharts before = std::move(best.charts);
  best.charts = {chartsOf(welded, best.open), {}};
  best.charts.flat.resize(best.charts.set.size());
  moveSame(before, best.charts);
  moveSame(other.charts, best.charts);
  return true;
}

}  // namespace abflat
