#pragma once

#include "unwrap/fixed.h"
#include "unwrap/open_surface.h"

namespace abflat {

/// Some triangles of a surface, in their order, as a surface of their own.
class KeptTriangles {
 public:
  explicit KeptTriangles(const IdVector<SurfaceTriangle, std::uint8_t>& isKept);

  /// Picks values of the whole. Nothing remains nothing.
  template <class T>
  IdVector<SurfaceTriangle, T> ofTriangles(const IdVector<SurfaceTriangle, T>& whole) const {
    IdVector<SurfaceTriangle, T> out;
    if (whole.empty()) return out;
    for (const SurfaceTriangle f : kept_) out.push_back(whole[f]);
    return out;
  }
  template <class T>
  IdVector<SurfaceCorner, T> ofCorners(const IdVector<SurfaceCorner, T>& whole) const {
    IdVector<SurfaceCorner, T> out;
    if (whole.empty()) return out;
    for (const SurfaceTriangle f : kept_)
      for (const SurfaceCorner c : cornersOf(f)) out.push_back(whole[c]);
    return out;
  }

  /// Open where it was beside triangles that are not kept.
  Surface surface(const Surface& whole, std::size_t vertices) const;
  FixedTriangles fixed(FixedTriangles whole) const;

 private:
  IdVector<SurfaceTriangle, SurfaceTriangle> kept_;    ///< in the whole
  IdVector<SurfaceTriangle, SurfaceTriangle> number_;  ///< the other way round
};

/// Charts of a cut surface as a surface of their own, which is open where it was cut. `isKept`: per
/// triangle, the same for all of a chart.
OpenSurface keptCharts(const OpenSurface& whole,
                       const IdVector<SurfaceTriangle, std::uint8_t>& isKept);

}  // namespace abflat
