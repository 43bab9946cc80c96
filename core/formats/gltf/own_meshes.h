#pragma once

#include "gltf/document.h"

namespace abflat::gltf {

/// Gives every node of the scene a mesh of its own: the first node of a mesh keeps it, the others
/// get copies, which refer to the same accessors.
void giveOwnMeshes(Document& document);

}  // namespace abflat::gltf
