#pragma once

#include "cut/surface_mesh.h"
#include "mesh/triangle_geometry.h"

namespace abflat {

using FlatRegionId = Id<struct FlatRegionIdTag>;

/// The flat regions of a surface: triangles in one plane that hang together, and the rest of their
/// faces. Those that fill holes are in none. Keeps a reference to the mesh.
class FlatRegions {
 public:
  explicit FlatRegions(const SeamMesh& mesh);

  FlatRegionId of(SurfaceTriangle f) const { return ofTriangle_[f]; }
  std::size_t count() const { return count_; }

  bool isBorder(SurfaceCorner h) const {
    return !mesh_.isOnSurface(h) ||
           ofTriangle_[triangleOf(h)] != ofTriangle_[triangleOf(mesh_.twin[h])];
  }
  /// Whether the surface bends there by more than the angle with this cosine.
  bool isCrease(SurfaceCorner h, double cosine) const {
    return mesh_.isOnSurface(h) &&
           dot(normal_[triangleOf(h)], normal_[triangleOf(mesh_.twin[h])]) < cosine;
  }

 private:
  void spread(SurfaceTriangle first);

  const SeamMesh& mesh_;
  IdVector<SurfaceTriangle, Vec3> normal_;
  IdVector<SurfaceTriangle, FlatRegionId> ofTriangle_;
  std::size_t count_ = 0;
};

}  // namespace abflat
