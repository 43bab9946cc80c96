#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "abflat/corner_attribute.h"
#include "abflat/export.h"
#include "abflat/mesh.h"

namespace abflat {

struct ComparedMesh {
  const PolygonMesh& mesh;
  const std::vector<CornerAttribute>& attributes;
};

struct CompareMeshesOptions {
  bool faceOrder = true;    ///< faces have to be in the same order
  bool vertexOrder = true;  ///< likewise; new ones may follow
};

enum class MeshDifferenceKind : std::uint8_t {
  Geometry,   ///< faces are missing, new, moved or turned around
  Order,      ///< faces or vertices are in another order
  Attribute,  ///< corners have other values
};

struct MeshDifference {
  MeshDifferenceKind kind = MeshDifferenceKind::Geometry;
  std::string message;               ///< one sentence, without a full stop
  std::vector<std::uint32_t> faces;  ///< of the new mesh, ascending, all of them
};

/// In what `now` differs from the mesh that it was made from, apart from texcoords. Places are the
/// same up to a millionth of the diagonal of `was`, as single precision keeps them. Polygons may
/// have become triangles, and vertices may have copies. Close to linear.
/// Errors: InvalidMesh.
ABFLAT_API Result<std::vector<MeshDifference>> compareMeshes(
    const ComparedMesh& was, const ComparedMesh& now, const CompareMeshesOptions& options = {});

}  // namespace abflat
