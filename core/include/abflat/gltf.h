#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "abflat/appearance.h"
#include "abflat/corner_attribute.h"
#include "abflat/export.h"
#include "abflat/mesh.h"
#include "abflat/status.h"

namespace abflat {

namespace gltf {
struct Source;  // the file, and how the mesh was made from it
}

/// A glTF 2.0 file, plain or compressed with Draco or meshopt, as one mesh: the triangles of all
/// primitives of the scene, in file order, each mesh placed by the node that makes it largest.
/// Texcoords are those of one set, with v upwards; materials are those of the file. Its meshes are
/// objects, which unwrap does not join where they touch.
struct GltfModel {
  PolygonMesh mesh;
  std::vector<std::string> notes;  ///< what is not in the mesh, one sentence each
  std::shared_ptr<const gltf::Source> source;
};

/// Whether the bytes begin like a .glb or .gltf file.
ABFLAT_API bool looksLikeGltf(std::string_view bytes);

struct GltfReadOptions {
  std::size_t texcoord = 0;  ///< N of the TEXCOORD_N to read
  /// Nodes that share a mesh each get a copy of it, which is part of the mesh and of what writeGltf
  /// writes, with texcoords of its own.
  bool ownTexels = false;
};

/// Reads a .glb or .gltf file. `fileName` is used in messages only. Errors: ParseError,
/// UnreadableFile (a file it refers to); messages name file and place.
ABFLAT_API Result<GltfModel> readGltf(std::string_view bytes, const std::string& fileName,
                                      const ReadResource& readResource,
                                      const GltfReadOptions& options = {});

/// What the file says about the corners of the mesh as it was read, beyond positions, normals,
/// tangents, materials, and TEXCOORD_N of that N. Morph targets are among it.
ABFLAT_API std::vector<CornerAttribute> gltfAttributes(const gltf::Source& source,
                                                       std::size_t texcoord);

/// A glTF repeats vertices where normals or texcoords change. Makes faces use the first vertex at
/// each position, whatever object it is of, unless the mesh is already a disk, which may be because
/// it was cut. Returns how many vertices are no longer used.
ABFLAT_API std::size_t joinVertices(PolygonMesh& mesh);

/// New images for the layout that is written, and which of them materials use.
struct GltfBaked {
  std::vector<ImageFile> images;  ///< PNG, JPEG or WebP, in which case files need EXT_texture_webp
  std::size_t baseColor = kNoImage, metallicRoughness = kNoImage, normal = kNoImage,
              occlusion = kNoImage, emissive = kNoImage;  ///< kNoImage: as it was
  double emissiveStrength = 1;
};

struct GltfWriteOptions {
  bool isBinary = true;      ///< .glb; otherwise .gltf with the buffer in a data URI
  std::size_t texcoord = 0;  ///< N of the TEXCOORD_N to write; other sets stay
  /// Path from the folder of the new file to that of the old one, for images in separate files.
  /// Empty for the same folder.
  std::string pathToSource;
  std::vector<std::uint32_t> turnedFaces;  ///< to be turned, see turnFaces
  /// Materials of the mesh are replaced by ones that use these images with the new texcoords, and
  /// those that do not differ in more than their name become one. What nothing uses any more is
  /// left out, unless the file has an extension that may refer to it. Null for none.
  const GltfBaked* baked = nullptr;
};

/// The file with texcoords `uv` (v upwards) for the triangles of its mesh; `cornerUv` has the
/// texcoord of each face corner, after faces were turned. A vertex with several texcoords is
/// duplicated after the existing vertices, with all of its attributes and morph targets. Everything
/// else stays, but uncompressed: bytes that nothing refers to any more are dropped, and all buffers
/// become one. Missing TEXCOORD sets below the written one get the same texcoords. Errors:
/// CannotWrite (a .glb of 4 GB).
ABFLAT_API Result<std::string> writeGltf(const gltf::Source& source, const std::vector<double>& uv,
                                         const std::vector<std::uint32_t>& cornerUv,
                                         const GltfWriteOptions& options);

struct GltfMakeOptions {
  bool isBinary = true;      ///< as in GltfWriteOptions
  std::size_t texcoord = 0;  ///< likewise
  bool isBaked = false;      ///< images are for the new texcoords, not for those of the mesh
};

/// A new .glb, or .gltf with its buffer in a data URI: the mesh as triangles with texcoords and
/// what is known of its look, images included. `triangleCorners` has 3 face corners per triangle,
/// ordered by face. They are the triangles of the layout, so that the file contains exactly what
/// was checked. There is a mesh and a node for each object and a primitive for each of its
/// materials, with triangles in face order. Where single precision would show, nodes are translated
/// and positions relative to them. The mesh's own texcoords become set 0 if another set is
/// written; if set 0 is written and an image needs them, they become set 1. `uv` may be empty to
/// write no texcoords. Errors: CannotWrite (a .glb of 4 GB, a coordinate that is too large).
ABFLAT_API Result<std::string> makeGltf(const PolygonMesh& mesh, const std::vector<double>& uv,
                                        const std::vector<std::uint32_t>& cornerUv,
                                        const std::vector<std::uint32_t>& triangleCorners,
                                        const Appearance& look, const GltfMakeOptions& options);

/// Says how far coordinates are from the origin, or how far a made glTF moves them, if that would
/// show. Empty if nothing does.
ABFLAT_API std::string originNote(const PolygonMesh& mesh,
                                  const std::vector<std::uint32_t>& triangleCorners);

/// Corners of the triangles that represent the faces if there is no layout.
ABFLAT_API std::vector<std::uint32_t> triangleCornersOf(const PolygonMesh& mesh);

/// N of a TEXCOORD_N that can be written without disturbing any texture: 0 if no texture of the
/// triangles samples set 0, otherwise the first set that no primitive has and no texture samples.
/// With `isBaked`, textures that GltfBaked replaces do not count.
ABFLAT_API std::size_t freeTexcoord(const gltf::Source& source, bool isBaked = false);

/// Says why new texcoords are in a set above 0, and what else to do.
ABFLAT_API std::string texcoordNote(const gltf::Source& source, std::size_t texcoord);

/// Says that the file was compressed with Draco or meshopt, while the output is not. Empty if it
/// was not compressed.
ABFLAT_API std::string compressionNote(const gltf::Source& source);

/// What becomes stale with new texcoords, one sentence each.
ABFLAT_API std::vector<std::string> staleNotes(const gltf::Source& source, std::size_t texcoord);

}  // namespace abflat
