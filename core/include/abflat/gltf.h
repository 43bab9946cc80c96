#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "abflat/appearance.h"
#include "abflat/mesh.h"
#include "abflat/status.h"

namespace abflat {

namespace gltf {
struct Source;  // the file, and how the mesh was made from it
}

/// A glTF 2.0 file, compressed by Draco or meshopt or plain, as one mesh: the triangles of all
/// primitives of the scene, in the order of the file, each mesh where the first node that uses it
/// puts it. Texcoords are those of TEXCOORD_0, with v upwards; materials are those of the file.
struct GltfModel {
  PolygonMesh mesh;
  std::vector<std::string> notes;  ///< what is not in the mesh, one sentence each
  std::shared_ptr<const gltf::Source> source;
};

/// Whether bytes begin as those of a .glb or .gltf file do.
bool looksLikeGltf(std::string_view bytes);

/// Reads a .glb or .gltf file. `fileName` is used in messages only.
/// Errors: ParseError, UnreadableFile (a file it refers to); messages name file and place.
Result<GltfModel> readGltf(std::string_view bytes, const std::string& fileName,
                           const ReadResource& readResource);

/// A glTF repeats vertices where normals or texcoords change. Faces get the first vertex at each
/// place; not where the mesh is a disk as it is, which may be so because it was cut. Returns how
/// many vertices are no longer used.
std::size_t joinVertices(PolygonMesh& mesh);

struct GltfWriteOptions {
  bool isBinary = true;      ///< .glb; otherwise .gltf with the buffer in a data URI
  std::size_t texcoord = 0;  ///< N of the TEXCOORD_N that is written; other sets stay
  /// Path from the folder of the new file to that of the old one, for images that are files of
  /// their own; empty: the same folder.
  std::string pathToSource;
};

/// The file with texcoords `uv` (v upwards) for the triangles of its mesh; `cornerUv` has the
/// texcoord of each face corner. Vertices with several texcoords are repeated behind the
/// others with all of their attributes and morph targets. Everything else stays, but uncompressed:
/// bytes that nothing refers to any more are left out, and all buffers become one. TEXCOORD sets
/// below the one that is written, where they are missing, are the same. Errors: CannotWrite (a .glb
/// of 4 GB).
Result<std::string> writeGltf(const gltf::Source& source, const std::vector<double>& uv,
                              const std::vector<std::uint32_t>& cornerUv,
                              const GltfWriteOptions& options);

struct GltfMakeOptions {
  bool isBinary = true;      ///< as in GltfWriteOptions
  std::size_t texcoord = 0;  ///< likewise
};

/// A new .glb, or .gltf with its buffer in a data URI: the mesh as triangles with texcoords and
/// what is known of its look, images included. `triangleCorners` has 3 face corners per triangle,
/// by face: those of the layout, so that the file has what was checked. A mesh and a node for each
/// object, a primitive for each material of it, triangles in the order of the faces. Texcoords that
/// the mesh has become set 0 where another one is written, and set 1 where set 0 is written and an
/// image needs them. `uv` may be empty: without texcoords. Errors: CannotWrite (a .glb of 4 GB, a
/// coordinate that is too large).
Result<std::string> makeGltf(const PolygonMesh& mesh, const std::vector<double>& uv,
                             const std::vector<std::uint32_t>& cornerUv,
                             const std::vector<std::uint32_t>& triangleCorners,
                             const Appearance& look, const GltfMakeOptions& options);

/// Corners of the triangles that stand for the faces where there is no layout.
std::vector<std::uint32_t> triangleCornersOf(const PolygonMesh& mesh);

/// N of a TEXCOORD_N that takes nothing from any texture: 0 where no texture of the triangles
/// samples that, otherwise the first set that no primitive has and no texture samples.
std::size_t freeTexcoord(const gltf::Source& source);

/// That the file was compressed with Draco or meshopt, which what is written is not; empty where it
/// was not.
std::string compressionNote(const gltf::Source& source);

/// What new texcoords make stale, one sentence each.
std::vector<std::string> staleNotes(const gltf::Source& source, std::size_t texcoord);

}  // namespace abflat
