#include "seam/hard_edges.h"

#include <cmath>

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

Seams byNormals(const SurfaceMap& map) {
  const PolygonMesh& input = map.input();
  const auto given = [&](SurfaceCorner c) { return input.faceNormals[map.corner(c)]; };
  const auto normal = [&](SurfaceCorner c) {
    const std::size_t i = given(c);
    if (i == kNoNormal) return facetNormal(map, triangleOf(c));
    Vec3 n{input.normals[3 * i], input.normals[3 * i + 1], input.normals[3 * i + 2]};
    const double length = norm(n);
    if (!std::isfinite(length) || !(length > 0)) return facetNormal(map, triangleOf(c));
    for (double& x : n) x /= length;
    return n;
  };
  const auto isHardAt = [&](SurfaceCorner a, SurfaceCorner b) {
    const bool isSame = given(a) == given(b) && given(a) != kNoNormal;
    return !isSame && doNormalsDiffer(normal(a), normal(b));
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
    return group(h) == 0 && doNormalsDiffer(facetNormal(map, triangleOf(h)),
                                            facetNormal(map, triangleOf(twin)));
  });
}

}  // namespace

Seams hardEdges(const SurfaceMap& map) {
  if (!map.input().faceNormals.empty()) return byNormals(map);
  if (!map.input().faceSmoothing.empty()) return byGroups(map);
  return {};
}

}  // namespace abflat
