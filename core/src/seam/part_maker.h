#pragma once

#include "seam/extract_charts.h"

namespace abflat {

/// Puts a part together, triangle by triangle, then corner by corner.
class PartMaker {
 public:
  explicit PartMaker(const SeamMesh& mesh);

  void reserve(std::size_t triangles, std::size_t vertices);
  void addTriangle(SurfaceTriangle f);
  SurfaceVertex addVertex(SurfaceVertex ofWhole);
  /// In the order of the triangles. `twin` is in the whole.
  void addCorner(SurfaceCorner h, SurfaceVertex v, SurfaceCorner twin);

  const IdVector<SurfaceCorner, SurfaceCorner>& corners() const { return part_.wholeHalfEdge; }
  SeamPart take();

 private:
  const SeamMesh& mesh_;
  IdVector<SurfaceCorner, SurfaceCorner> inPart_;
  SeamPart part_;
};

}  // namespace abflat
