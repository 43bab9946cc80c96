#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "cut/cut_surface.h"
#include "mesh/surface.h"

namespace abflat {

/// A place where faces of very different sizes meet.
struct ScaleJump {
  SurfaceTriangle large, small;
  double largeSide = 0, smallSide = 0;  ///< longest sides of the two faces
};

/// Groups of triangles of similar size.
struct Scales {
  IdVector<SurfaceTriangle, std::uint8_t> ofTriangle;  ///< empty if there is only one scale
  std::optional<ScaleJump> sharpest;                   ///< where two scales meet
};

/// Adds seams between faces that differ so much in size that no floating-point numbers could hold
/// both in one chart, such as where one vertex lies far off. A small number of tiny faces stays
/// with the others.
Scales addScaleSeams(const PolygonMesh& mesh, const Surface& surface, Seams& seams);

}  // namespace abflat
