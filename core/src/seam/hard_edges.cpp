#include "seam/hard_edges.h"

#include <cmath>
#include <vector>

#include "seam/bend.h"

namespace abflat {
namespace {

bool doNormalsDiffer(const Vec3& a, const Vec3& b) {
  return bendBetween(a, b) > kSameNormalDegrees;
}

/// Zero for a normal that has no direction.
std::vector<double> unitNormals(std::vector<double> normals) {
  for (std::size_t i = 0; i < normals.size(); i += 3) {
    const double length = norm({normals[i], normals[i + 1], normals[i + 2]});
    const bool hasDirection = std::isfinite(length) && length > 0;
    for (std::size_t d = i; d < i + 3; ++d) normals[d] = hasDirection ? normals[d] / length : 0;
  }
  return normals;
}

/// Decides by the normals that corners have, or their triangles.
class Normals {
 public:
  explicit Normals(const SurfaceMap& map)
      : map_(map), normals_(unitNormals(map.input().extras().normals)) {}

  bool areHard(SurfaceCorner h, SurfaceCorner twin) const {
    return differAt(h, nextCorner(twin)) || differAt(nextCorner(h), twin);
  }

  bool hasAny(SurfaceCorner h, SurfaceCorner twin) const {
    return isGiven(h) || isGiven(nextCorner(h)) || isGiven(twin) || isGiven(nextCorner(twin));
  }

 private:
  Vec3 given(std::uint32_t i) const {
    return {normals_[3 * std::size_t{i}], normals_[3 * std::size_t{i} + 1],
            normals_[3 * std::size_t{i} + 2]};
  }

  /// kNoNormal if it has no direction.
  std::uint32_t numberOf(SurfaceCorner c) const {
    const std::uint32_t i = map_.input().extras().faceNormals[map_.corner(c)];
    return i == kNoNormal || given(i) == Vec3{} ? kNoNormal : i;
  }

  bool isGiven(SurfaceCorner c) const { return numberOf(c) != kNoNormal; }

  bool differAt(SurfaceCorner a, SurfaceCorner b) const {
    const std::uint32_t i = numberOf(a), j = numberOf(b);
    if (i == j && i != kNoNormal) return false;
    return doNormalsDiffer(i == kNoNormal ? facetNormal(map_, triangleOf(a)) : given(i),
                           j == kNoNormal ? facetNormal(map_, triangleOf(b)) : given(j));
  }

  const SurfaceMap& map_;
  std::vector<double> normals_;  ///< of length 1
};

/// Whether smoothing groups make the edge between two triangles hard.
bool areHardByGroups(const SurfaceMap& map, SurfaceTriangle f, SurfaceTriangle g) {
  const std::vector<std::uint32_t>& groups = map.input().extras().faceSmoothing;
  const std::uint32_t group = groups[map.face(f)];
  if (group != groups[map.face(g)]) return true;
  return group == 0 && doNormalsDiffer(facetNormal(map, f), facetNormal(map, g));
}

}  // namespace

Seams hardEdges(const SurfaceMap& map) {
  const bool hasNormals = !map.input().extras().faceNormals.empty();
  const bool hasGroups = !map.input().extras().faceSmoothing.empty();
  if (!hasNormals && !hasGroups) return {};
  const Surface& surface = map.surface();
  const Normals normals(map);
  Seams out(surface.table.vertex.size(), 0);
  for (const SurfaceCorner h : surface.table.corners()) {
    const SurfaceCorner twin = surface.table.twin[h];
    if (!twin.exists() || twin < h || surface.triangulation.isDiagonal[h]) continue;
    const bool isByNormals = hasNormals && (!hasGroups || normals.hasAny(h, twin));
    out[h] = out[twin] = isByNormals ? normals.areHard(h, twin)
                                     : areHardByGroups(map, triangleOf(h), triangleOf(twin));
  }
  return out;
}

void addMaterialBorders(const SurfaceMap& map, Seams& breaks) {
  const auto& materials = map.input().extras().faceMaterials;
  if (materials.empty()) return;
  const IdVector<SurfaceCorner, SurfaceCorner>& twin = map.surface().table.twin;
  breaks.resize(twin.size(), 0);
  for (const SurfaceCorner h : twin.ids())
    if (twin[h].exists() &&
        materials[map.face(triangleOf(h))] != materials[map.face(triangleOf(twin[h]))])
      breaks[h] |= kMaterialBorder;
}

}  // namespace abflat
