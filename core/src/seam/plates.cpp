#include "seam/plates.h"

#include <algorithm>
#include <vector>

#include "base/stable_order.h"
#include "cut/flat_regions.h"

namespace abflat {
namespace {

class Plates {
 public:
  explicit Plates(const SeamMesh& mesh) : mesh_(mesh), regions_(mesh) {}

  Seams borders() const {
    const std::vector<std::uint8_t> isPlate = plates();
    Seams out;
    if (std::find(isPlate.begin(), isPlate.end(), 1) == isPlate.end()) return out;
    out.assign(mesh_.twin.size(), 0);
    for (const SurfaceCorner h : mesh_.corners()) {
      const FlatRegionId region = regions_.of(triangleOf(h));
      if (!region.exists() || !isPlate[region] || !regions_.isBorder(h) ||
          !regions_.isCrease(h, kCrease))
        continue;
      out[h] = out[mesh_.twin[h]] = 1;
    }
    return out;
  }

 private:
  static constexpr double kCrease = 0.8660254;  // cosine of 30 degrees
  /// Plates that make up less of the surface are not worth a second search: steps and dirt have
  /// flat spots with holes, too.
  static constexpr double kLeastShare = 1e-3;

  /// Regions whose Euler characteristic, 2 less the number of boundary loops, tells of several
  /// holes.
  std::vector<std::uint8_t> plates() const {
    constexpr int kMostOfOthers = 0;  // that of a disk with a hole
    std::vector<int> euler(regions_.count(), 0);
    for (const SurfaceTriangle f : mesh_.triangles())
      if (const FlatRegionId region = regions_.of(f); region.exists()) ++euler[region];
    // Edges inside count half from either side.
    std::vector<int> halves(regions_.count(), 0);
    for (const SurfaceCorner h : mesh_.corners())
      if (const FlatRegionId region = regions_.of(triangleOf(h)); region.exists())
        halves[region] += regions_.isBorder(h) ? 2 : 1;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> places;
    for (const SurfaceCorner c : mesh_.corners())
      if (const FlatRegionId region = regions_.of(triangleOf(c)); region.exists())
        places.emplace_back(region, mesh_.vertexOfCorner[c]);
    sortStably(places, std::less<>());
    places.erase(std::unique(places.begin(), places.end()), places.end());
    for (const auto& place : places) ++euler[place.first];
    std::vector<std::uint8_t> out;
    for (std::size_t r = 0; r < regions_.count(); ++r)
      out.push_back(euler[r] - halves[r] / 2 <= kMostOfOthers);
    if (shareOf(out) < kLeastShare) out.assign(regions_.count(), 0);
    return out;
  }

  /// Of the surface, how much lies in these regions.
  double shareOf(const std::vector<std::uint8_t>& isAsked) const {
    double area = 0;
    for (const SurfaceTriangle f : mesh_.triangles())
      if (const FlatRegionId region = regions_.of(f); region.exists() && isAsked[region])
        area += mesh_.area[f];
    return area / mesh_.totalArea();
  }

  const SeamMesh& mesh_;
  const FlatRegions regions_;
};

}  // namespace

Seams plateBorders(const SeamMesh& mesh) { return Plates(mesh).borders(); }

}  // namespace abflat
