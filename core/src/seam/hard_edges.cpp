#include "seam/hard_edges.h"

#include <cmath>
#include <vector>

#include "seam/bend.h"

namespace abflat {
namespace {

bool doNormalsDiffer(const Vec3& a, const Vec3& b) {
  return bendBetween(a, b) > kSameNormalDegrees;
}

/// Calls isHard(half-edge, twin) once for each edge of a face with two sides.
template <class IsHard>
Seams edgesThat(const Surface& surface, const IsHard& isHard) {
  Seams out(surface.table.vertex.size(), 0);
  for (const SurfaceCorner h : surface.table.corners()) {
    const SurfaceCorner twin = surface.table.twin[h];
    if (!twin.exists() || twin < h || surface.triangulation.isDiagonal[h]) continue;
    out[h] = out[twin] = isHard(h, twin);
  }
  return out;
}

/// Zero for a normal that has no direction.
std::vector<Vec3> unitNormals(const std::vector<double>& normals) {
  std::vector<Vec3> out;
  out.reserve(normals.size() / 3);
  for (std::size_t i = 0; i < normals.size(); i += 3) {
    Vec3 n{normals[i], normals[i + 1], normals[i + 2]};
    const double length = norm(n);
    const bool hasDirection = std::isfinite(length) && length > 0;
    for (double& x : n) x = hasDirection ? x / length : 0;
    out.push_back(n);
  }
  return out;
}

Seams byNormals(const SurfaceMap& map) {
  const PolygonMesh& input = map.input();
  const std::vector<Vec3> normals = unitNormals(input.normals);
  const auto given = [&](SurfaceCorner c) {
    const std::uint32_t i = input.faceNormals[map.corner(c)];
    return i == kNoNormal || normals[i] == Vec3{} ? kNoNormal : i;
  };
  const auto isHardAt = [&](SurfaceCorner a, SurfaceCorner b) {
    const std::uint32_t i = given(a), j = given(b);
    if (i == j && i != kNoNormal) return false;
    return doNormalsDiffer(i == kNoNormal ? facetNormal(map, triangleOf(a)) : normals[i],
                           j == kNoNormal ? facetNormal(map, triangleOf(b)) : normals[j]);
  };
  return edgesThat(map.surface(), [&](SurfaceCorner h, SurfaceCorner twin) {
    return isHardAt(h, nextCorner(twin)) || isHardAt(nextCorner(h), twin);
  });
}

Seams byGroups(const SurfaceMap& map) {
  const auto group = [&](SurfaceCorner c) {
    return map.input().faceSmoothing[map.face(triangleOf(c))];
  };
  return edgesThat(map.surface(), [&](SurfaceCorner h, SurfaceCorner twin) {
    if (group(h) != group(twin)) return true;
    return group(h) == 0 &&
           doNormalsDiffer(facetNormal(map, triangleOf(h)), facetNormal(map, triangleOf(twin)));
  });
}

}  // namespace

Seams hardEdges(const SurfaceMap& map) {
  if (!map.input().faceNormals.empty()) return byNormals(map);
  if (!map.input().faceSmoothing.empty()) return byGroups(map);
  return {};
}

}  // namespace abflat
