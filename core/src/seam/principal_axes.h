#pragma once

#include <array>

#include "cut/surface_mesh.h"
#include "mesh/triangle_geometry.h"

namespace abflat {

/// Where a surface lies, and along which perpendicular unit vectors it spreads, most along the
/// first one.
struct PrincipalAxes {
  Vec3 middle{};
  std::array<Vec3, 3> axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
};

/// Those of the coordinates where the surface spreads alike in all directions. The surface reaches
/// farther, on average, where its axes point to.
PrincipalAxes principalAxes(const SeamMesh& mesh);

/// The middle of a triangle.
Vec3 centreOf(const SeamMesh& mesh, SurfaceTriangle triangle);

}  // namespace abflat
