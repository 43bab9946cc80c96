#pragma once

#include <cstdint>
#include <vector>

#include "abflat/mesh.h"
#include "base/listener.h"

namespace abflat {

/// Faces that have the same vertices, in layers that lie on top of each other.
struct RepeatedFaces {
  std::vector<std::uint32_t> original;  ///< per face the first one with its vertices, kNone: itself
  /// Per face 0, or 1 and more for further ones with the same vertices. Faces of a layer run like
  /// the faces beside them, so that a surface that is there twice is two surfaces.
  std::vector<std::uint32_t> layer;
};

/// The result is unusable if the listener has stopped.
RepeatedFaces findRepeated(const PolygonMesh& mesh, const Listener& listener);

}  // namespace abflat
