#pragma once

#include <vector>

#include "gltf/document.h"

namespace abflat::gltf {

/// Placement of a mesh in the scene.
struct MeshPlace {
  bool isUsed = false;     ///< by a node of the scene
  Matrix matrix{};         ///< to the scene, by columns
  double determinant = 1;  ///< below 0: mirrored
  std::size_t nodes = 0;   ///< of the scene that use it
  bool hasScales = false;  ///< these make it differently large
};

/// For each mesh, where the node that makes it largest puts it, the first of several. Skinned
/// meshes stay where they are, and so do those whose nodes squeeze them flat. Without a scene all
/// meshes are used as they are.
/// Errors: ParseError (nodes that are their own descendants, numbers that are not finite).
Result<std::vector<MeshPlace>> meshPlaces(const Document& document);

}  // namespace abflat::gltf
