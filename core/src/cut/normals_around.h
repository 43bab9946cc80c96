#pragma once

#include <cstddef>
#include <vector>

#include "cut/surface_mesh.h"
#include "mesh/triangle_geometry.h"

namespace abflat {

/// Mean normals of the surface around points, so that the side of a nose faces where the face does.
/// Triangles count by area, and the less the farther they are, up to about a tenth of the root of
/// the mesh's area.
class NormalsAround {
 public:
  explicit NormalsAround(const SeamMesh& mesh);
  /// The unit normal around the middle of an edge; zero where the surface faces all ways alike.
  Vec3 at(SurfaceCorner edge) const;

 private:
  template <class Visit>
  void visitCells(const Vec3& point, const Visit& visit) const;
  Vec3 middleOf(SurfaceCorner edge) const;

  const SeamMesh& mesh_;
  double width_ = 1;       ///< of a cell
  std::size_t cells_ = 1;  ///< along a side
  Vec3 low_{};
  std::vector<Vec3> sum_;  ///< per cell
};

}  // namespace abflat
