#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "abflat/export.h"
#include "abflat/generated/mesh_format.h"
#include "abflat/mesh.h"
#include "abflat/status.h"

namespace abflat {

/// Detects the format by the extension of a file name (see kMeshEndings, any case), or by the first
/// bytes if the extension is unknown. Errors: UnreadableFile when neither tells.
ABFLAT_API Result<MeshFormat> detectFormat(std::string_view fileName, std::string_view bytes);

/// Parses a whole file. STL has no connectivity: corners at identical coordinates become one
/// vertex. `fileName` is used in messages only. Texcoords that cannot be read or do not exist are
/// dropped, since a mesh does not need them. Errors: ParseError (names file and line, or byte of a
/// binary file).
ABFLAT_API Result<PolygonMesh> readMesh(std::string_view bytes, MeshFormat format,
                                        std::string_view fileName);

/// OBJ text of the mesh with texcoords; faces keep their order, corner order and degree. `uv` has 2
/// coordinates per texcoord, `cornerUv` the texcoord of each face corner (size of faceVertices), or
/// kNoTexcoord, which other formats write as 0 0.
/// When `sourceObj` is the OBJ text that `mesh` was read from, everything but texcoords, references
/// to them, and faces is copied from it byte for byte (positions, comments, groups, materials,
/// normals). `turnedFaces`, ascending, are those that `mesh` has turned since. Otherwise positions
/// are written so that they read back to the same doubles.
ABFLAT_API std::string writeObj(const PolygonMesh& mesh, const std::vector<double>& uv,
                                const std::vector<std::uint32_t>& cornerUv,
                                std::string_view sourceObj = {},
                                const std::vector<std::uint32_t>& turnedFaces = {});

/// PLY of the mesh with texcoords: vertex properties `s` and `t`, stored as `float` if every
/// coordinate of `uv` fits one exactly and as `double` otherwise. Arguments as for writeObj.
/// Vertices and faces keep their order; a vertex with several texcoords is duplicated after all
/// others. When `sourcePly` is the PLY file that `mesh` was read from, its encoding and all other
/// elements, properties and comments are copied byte for byte, and its own texcoords are replaced;
/// otherwise the file is binary.
ABFLAT_API std::string writePly(const PolygonMesh& mesh, const std::vector<double>& uv,
                                const std::vector<std::uint32_t>& cornerUv,
                                std::string_view sourcePly = {});

/// A file of any format that has a precision; empty for one that is only read. Arguments as for
/// writeObj; `source` is a file of the same format.
ABFLAT_API std::string writeMesh(MeshFormat format, const PolygonMesh& mesh,
                                 const std::vector<double>& uv,
                                 const std::vector<std::uint32_t>& cornerUv,
                                 std::string_view source = {},
                                 const std::vector<std::uint32_t>& turnedFaces = {});

}  // namespace abflat
