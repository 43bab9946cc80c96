#pragma once

#include <optional>

#include "cut/surface_mesh.h"
#include "seam/vertex_cells.h"

namespace abflat {

/// How far a vertex may be from the image of another one, in the unit cube.
constexpr double kMirrorTolerance = 1e-3;

struct MirrorPlane {
  Vec3 normal{};
  double distance = 0;

  double of(const Vec3& p) const { return dot(normal, p) - distance; }
  Vec3 image(Vec3 p) const {
    const double twice = 2 * of(p);
    for (std::size_t i = 0; i < 3; ++i) p[i] -= twice * normal[i];
    return p;
  }
};

/// The plane that most vertices have an image at, even if a part of the mesh has none. None if it
/// is far from being one for most of the vertices. `cells`: of all vertices.
std::optional<MirrorPlane> findMirrorPlane(const SeamMesh& mesh, const VertexCells& cells,
                                           const Listener& listener);

}  // namespace abflat
