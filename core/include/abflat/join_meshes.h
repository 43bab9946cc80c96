#pragma once

#include <cstdint>
#include <vector>

#include "abflat/export.h"
#include "abflat/mesh.h"
#include "abflat/unwrap.h"

namespace abflat {

/// Several meshes as one, for an atlas that they share: vertices and faces of the first, then those
/// of the second, and so on. Each keeps its objects, or becomes one. Where z points up in some of
/// them, they are turned so that y does in all. Errors: InvalidMesh, also if there are more than
/// 4294967295 vertices or corners in all.
ABFLAT_API Result<PolygonMesh> joinMeshes(const std::vector<const PolygonMesh*>& meshes);

/// The part of a layout that belongs to one of the joined meshes; names as in UnwrapResult.
struct JoinedPart {
  std::vector<double> uv;
  std::vector<std::uint32_t> cornerUv;
  std::vector<std::uint32_t> chartOfFace;      ///< in the report of the whole layout
  std::vector<std::uint32_t> triangleCorners;  ///< counted from the first corner of the mesh
  std::vector<std::uint32_t> turnedFaces;      ///< ascending, counted from its first face
};

/// The layout of each mesh, from that of joinMeshes(meshes).
ABFLAT_API std::vector<JoinedPart> splitLayout(const UnwrapResult& joined,
                                               const std::vector<const PolygonMesh*>& meshes);

/// Turns the faces of a mesh that its layout has turned, as for an UnwrapResult.
ABFLAT_API void turnFaces(PolygonMesh& mesh, JoinedPart& layout);

}  // namespace abflat
