#include "unwrap/flat_faces.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "cut/flat_regions.h"
#include "hole/fill_holes.h"
#include "unwrap/stretch.h"

namespace abflat {
namespace {

/// A flat face, and how it lies in its chart.
struct FlatFace {
  double area = 0;
  ChartId chart;                          ///< one of them, where there are several
  bool isInSeveral = false;               ///< charts
  bool isHeld = false;                    ///< by the rest of its chart
  bool isByCreases = true;                ///< all that holds it
  double cost = 0;                        ///< of a seam there
  double solid = 0, drawn = 0, both = 0;  ///< sums of products of the lengths of edges

  /// By how much edges are longer or shorter than on the surface, for their length, once both have
  /// the same scale: the root of the mean square.
  double bent() const {
    return both > 0 ? std::sqrt(std::max(0., solid * drawn / (both * both) - 1)) : 0;
  }
};

class FlatFaces {
 public:
  FlatFaces(const LaidCharts& charts, const OpenSurface& open)
      : charts_(charts), open_(open), regions_(open.mesh), faces_(regions_.count()) {
    for (const ChartId i : charts.set.ids()) measure(i);
  }

  /// The seams around those that are worth it.
  std::vector<SurfaceCorner> seams() const {
    const double area = open_.mesh.totalArea();
    std::vector<SurfaceCorner> out;
    for (const SurfaceCorner h : open_.mesh.corners()) {
      const FlatRegionId region = regions_.of(triangleOf(h));
      if (region.exists() && isHeldAlong(h) && isWorth(faces_[region], area)) out.push_back(h);
    }
    return out;
  }

 private:
  bool isHeldAlong(SurfaceCorner h) const {
    return regions_.isBorder(h) && open_.mesh.isOnSurface(h) && !open_.seams[h];
  }

  bool isWorth(const FlatFace& face, double area) const {
    constexpr double kLeastShare = 0.01;  // of the surface
    constexpr double kBent = 0.01;
    constexpr double kWorth = 0.5;  // of the root of its area as a seam in plain sight
    if (!face.isHeld || face.isInSeveral || !face.isByCreases || face.area < kLeastShare * area)
      return false;
    const FlatChart& flat = charts_.flat[face.chart];
    return flat.problem.empty() && !flat.isFixed && face.bent() > kBent &&
           face.cost <= kWorth * std::sqrt(face.area);
  }

  void measure(ChartId i) {
    constexpr double kCrease = 0.7071068;  // cosine of 45 degrees
    const SeamMesh& mesh = open_.mesh;
    const ChartTopology chart = charts_.set.topology(i);
    const std::vector<double>& uv = charts_.flat[i].unpacked;
    if (uv.empty()) return;
    for (const ChartCorner c : chart.surfaceCorners()) {
      const SurfaceCorner h = chart.onSurface(c);
      const FlatRegionId region = regions_.of(triangleOf(h));
      if (!region.exists()) continue;
      FlatFace& face = faces_[region];
      if (placeInTriangle(h) == 0) face.area += mesh.area[triangleOf(h)];
      face.isInSeveral |= face.chart.exists() && face.chart != i;
      face.chart = i;
      const ChartVertex a = chart.vertexOfCorner[c], b = chart.vertexOfCorner[nextCorner(c)];
      const double u = uv[2 * b] - uv[2 * a], v = uv[2 * b + 1] - uv[2 * a + 1];
      face.solid += mesh.length[h] * mesh.length[h];
      face.drawn += u * u + v * v;
      face.both += mesh.length[h] * std::sqrt(u * u + v * v);
      if (!isHeldAlong(h)) continue;
      face.isHeld = true;
      face.isByCreases &= regions_.isCrease(h, kCrease);
      face.cost += mesh.cost[h];
    }
  }

  const LaidCharts& charts_;
  const OpenSurface& open_;
  const FlatRegions regions_;
  IdVector<FlatRegionId, FlatFace> faces_;
};

}  // namespace

Seams cutOutFlatFaces(const LaidCharts& charts, const UnwrapOptionValues& options,
                      OpenSurface& open) {
  open.seams.resize(open.mesh.twin.size(), 0);
  const std::vector<SurfaceCorner> found = FlatFaces(charts, open).seams();
  if (found.empty()) return {};
  Seams before = open.seams;
  const auto set = [&](SurfaceCorner h, std::uint8_t to) {
    open.seams[h] = open.seams[open.mesh.twin[h]] = to;
  };
  for (const SurfaceCorner h : found) set(h, 1);
  // A face that the rest surrounds leaves a ring.
  const CutSurface cut = cutAlong(open.mesh, open.seams);
  IdVector<ChartId, std::uint8_t> isRing(charts.set.size(), 0);
  for (const CutSurface::Chart& chart : cut.charts)
    if (!chart.isDisk() && !open.mesh.isFilling(chart.firstTriangle))
      isRing[charts.set.ofTriangle[chart.firstTriangle]] = 1;
  bool isAny = false;
  for (const SurfaceCorner h : found) {
    const bool isTaken = !isRing[charts.set.ofTriangle[triangleOf(h)]];
    if (!isTaken) set(h, 0);
    isAny |= isTaken;
  }
  if (!isAny) return {};
  openTouchedHoles(open.mesh, cutAlong(open.mesh, open.seams), options.fillHoles, open.seams);
  return before;
}

IdVector<ChartId, std::uint8_t> worseCutOut(const LaidCharts& before, const LaidCharts& now,
                                            const UnwrapOptionValues& options) {
  IdVector<ChartId, std::uint8_t> out(before.set.size(), 0);
  IdVector<ChartId, double> stretch(before.set.size(), 0);
  const auto excess = [](const FlatChart& flat) {
    return flat.area * (flat.distortion.symmetricDirichlet - 1);
  };
  for (const ChartId i : now.set.ids()) {
    const FlatChart& flat = now.flat[i];
    const ChartId former = before.set.ofTriangle[now.set.topology(i).triangles.front()];
    out[former] |= !flat.problem.empty() || isStretched(flat, now.set.leewayOf(i), options);
    stretch[former] += excess(flat);
  }
  for (const ChartId i : before.set.ids())
    out[i] |= stretch[i] > (1 + 1e-9) * excess(before.flat[i]);
  return out;
}

}  // namespace abflat
