#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "cut/cut_surface.h"
#include "mesh/surface.h"

namespace abflat {

/// Where faces of very different size meet.
struct ScaleJump {
  SurfaceTriangle large, small;
  double largeSide = 0, smallSide = 0;  ///< the longest of their faces
};

/// Which triangles are alike in size.
struct Scales {
  IdVector<SurfaceTriangle, std::uint8_t> ofTriangle;  ///< empty where all are
  std::optional<ScaleJump> sharpest;                   ///< where two scales meet
};

/// Adds seams between faces so different in size that no numbers could hold both in one chart, as
/// where one vertex lies far off. Tiny faces that are few stay with the others.
Scales addScaleSeams(const PolygonMesh& mesh, const Surface& surface, Seams& seams);

}  // namespace abflat
