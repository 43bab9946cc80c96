#include "cut/flat_regions.h"

#include <cmath>
#include <vector>

#include "cut/mesh_parts.h"

namespace abflat {

FlatRegions::FlatRegions(const SeamMesh& mesh)
    : mesh_(mesh), normal_(triangleNormals(mesh)), ofTriangle_(mesh.triangleCount()) {
  for (const SurfaceTriangle f : mesh.triangles())
    if (!ofTriangle_[f].exists() && !mesh.isFilling(f)) spread(f);
}

/// To all triangles around `first` that lie in its plane, and the rest of their faces.
void FlatRegions::spread(SurfaceTriangle first) {
  constexpr double kFlat = 1 - 1e-6;  // cosine between neighbours
  const FlatRegionId region(count_++);
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

}  // namespace abflat
