#include "seam/plates.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/stable_order.h"
#include "cut/mesh_parts.h"
#include "mesh/triangle_geometry.h"

namespace abflat {
namespace {

using RegionId = Id<struct RegionIdTag>;

class Regions {
 public:
  explicit Regions(const SeamMesh& mesh)
      : mesh_(mesh), normal_(triangleNormals(mesh)), ofTriangle_(mesh.triangleCount()) {
    for (const SurfaceTriangle f : mesh.triangles())
      if (!ofTriangle_[f].exists() && !mesh.isFilling(f)) spread(f);
  }

  Seams bordersOfPlates() const {
    const std::vector<std::uint8_t> isPlate = plates();
    Seams out;
    if (std::find(isPlate.begin(), isPlate.end(), 1) == isPlate.end()) return out;
    out.assign(mesh_.twin.size(), 0);
    for (const SurfaceCorner h : mesh_.corners()) {
      const RegionId region = ofTriangle_[triangleOf(h)];
      if (!region.exists() || !isPlate[region] || !isBorder(h) || !isCrease(h)) continue;
      out[h] = out[mesh_.twin[h]] = 1;
    }
    return out;
  }

 private:
  static constexpr double kFlat = 1 - 1e-6;     // cosine between neighbours
  static constexpr double kCrease = 0.8660254;  // cosine of 30 degrees
  /// Plates that make up less of the surface are not worth a second search: steps and dirt have
  /// flat spots with holes, too.
  static constexpr double kLeastShare = 1e-3;

  /// All triangles around `first` that lie in its plane, and the rest of their faces.
  void spread(SurfaceTriangle first) {
    const RegionId region(count_++);
    std::vector<SurfaceTriangle> open{first};
    ofTriangle_[first] = region;
    while (!open.empty()) {
      const SurfaceTriangle f = open.back();
      open.pop_back();
      for (const SurfaceCorner h : cornersOf(f)) {
        if (!mesh_.isOnSurface(h)) continue;
        const SurfaceTriangle next = triangleOf(mesh_.twin[h]);
        const bool isOneFace = std::isinf(mesh_.cost[h]);
        const bool isFlat = isOneFace || dot(normal_[first], normal_[next]) >= kFlat;
        if (ofTriangle_[next].exists() || !isFlat) continue;
        ofTriangle_[next] = region;
        open.push_back(next);
      }
    }
  }

  bool isBorder(SurfaceCorner h) const {
    return !mesh_.isOnSurface(h) ||
           ofTriangle_[triangleOf(h)] != ofTriangle_[triangleOf(mesh_.twin[h])];
  }
  bool isCrease(SurfaceCorner h) const {
    return mesh_.isOnSurface(h) &&
           dot(normal_[triangleOf(h)], normal_[triangleOf(mesh_.twin[h])]) < kCrease;
  }

  /// Regions whose Euler characteristic, 2 less the number of boundary loops, tells of several
  /// holes.
  std::vector<std::uint8_t> plates() const {
    constexpr int kMostOfOthers = 0;  // that of a disk with a hole
    std::vector<int> euler(count_, 0);
    for (const RegionId region : ofTriangle_)
      if (region.exists()) ++euler[region];
    // Edges inside count half from either side.
    std::vector<int> halves(count_, 0);
    for (const SurfaceCorner h : mesh_.corners())
      if (const RegionId region = ofTriangle_[triangleOf(h)]; region.exists())
        halves[region] += isBorder(h) ? 2 : 1;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> places;
    for (const SurfaceCorner c : mesh_.corners())
      if (const RegionId region = ofTriangle_[triangleOf(c)]; region.exists())
        places.emplace_back(region, mesh_.vertexOfCorner[c]);
    sortStably(places, std::less<>());
    places.erase(std::unique(places.begin(), places.end()), places.end());
    for (const auto& place : places) ++euler[place.first];
    std::vector<std::uint8_t> out;
    for (std::size_t r = 0; r < count_; ++r)
      out.push_back(euler[r] - halves[r] / 2 <= kMostOfOthers);
    if (shareOf(out) < kLeastShare) out.assign(count_, 0);
    return out;
  }

  /// Of the surface, how much lies in these regions.
  double shareOf(const std::vector<std::uint8_t>& isAsked) const {
    double area = 0;
    for (const SurfaceTriangle f : mesh_.triangles())
      if (const RegionId region = ofTriangle_[f]; region.exists() && isAsked[region])
        area += mesh_.area[f];
    return area / mesh_.totalArea();
  }

  const SeamMesh& mesh_;
  IdVector<SurfaceTriangle, Vec3> normal_;
  IdVector<SurfaceTriangle, RegionId> ofTriangle_;
  std::size_t count_ = 0;
};

}  // namespace

Seams plateBorders(const SeamMesh& mesh) { return Regions(mesh).bordersOfPlates(); }

}  // namespace abflat
