#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "abflat/bake.h"
#include "abflat/mesh.h"
#include "baking/new_layout.h"

namespace abflat::cli {

/// A mesh of polygons with texcoords and normals of its corners, as bake takes it: the triangles
/// of its layout. The mesh has turned faces already.
class ObjCorners {
 public:
  /// `triangleCorners` has 3 face corners per triangle, ordered by face.
  ObjCorners(const PolygonMesh& mesh, const NewLayout& layout,
             const std::vector<std::uint32_t>& triangleCorners);

  /// Both layouts and materials.
  BakeTriangles triangles() const;
  /// 4 numbers per corner, from as many per vertex.
  std::vector<float> colours(const std::vector<double>& ofVertices) const;
  /// What a normal map needs besides; its old texcoords count.
  void addFrames(BakeTriangles& triangles) const;

 private:
  const PolygonMesh& mesh_;
  const NewLayout& layout_;
  const std::vector<std::uint32_t>& corners_;
  std::vector<std::uint32_t> faces_;  ///< per triangle
};

}  // namespace abflat::cli
