#pragma once

#include <array>

#include "seam/extract_charts.h"

namespace abflat {

/// A plane that a mesh is symmetric to, apart from parts without an image and from rounding.
struct Mirror {
  /// 0 on the plane, 1 and -1 on its two sides. Less of the side 1 has no image.
  IdVector<SurfaceVertex, std::int8_t> side;
  /// Of each half-edge; none if it has no image. The image of an image is what was there before.
  IdVector<SurfaceCorner, SurfaceCorner> image;
  /// Where a diagonal runs the other way on the other side: the two edges that lead around it.
  IdVector<SurfaceCorner, std::array<SurfaceCorner, 2>> around;

  explicit operator bool() const { return !side.empty(); }

  /// On which side of the plane an edge lies; 0 if on it or across it.
  int sideOf(const SeamMesh& mesh, SurfaceCorner h) const {
    const int sum = side[mesh.tail(h)] + side[mesh.head(h)];
    return sum > 0 ? 1 : sum < 0 ? -1 : 0;
  }

  /// Whether it has an image, if only one that leads around a diagonal.
  bool hasImage(SurfaceCorner h) const { return image[h].exists() || around[h][0].exists(); }
  /// Calls visit() with the edges of its image, from the image of the tail to that of the head.
  template <typename Visit>
  void forEachImage(SurfaceCorner h, Visit visit) const {
    if (image[h].exists()) return visit(image[h]);
    for (const SurfaceCorner i : around[h])
      if (i.exists()) visit(i);
  }

  /// For a part of the mesh; edges whose image is elsewhere have none.
  Mirror ofPart(const SeamPart& part) const;
  /// For the whole, of which the part has everything in another order.
  Mirror ofWhole(const SeamPart& part) const;
};

/// False if most of the mesh has no image.
Mirror findMirror(const SeamMesh& mesh, const Listener& listener = {});

}  // namespace abflat
