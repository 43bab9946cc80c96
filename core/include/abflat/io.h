#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "abflat/mesh.h"
#include "abflat/status.h"

namespace abflat {

enum class MeshFormat { Obj, Off };

/// Format by the ending of a file name (".obj", ".off", any case); without a known ending by the
/// first bytes. Errors: UnreadableFile when neither tells.
Result<MeshFormat> detectFormat(std::string_view fileName, std::string_view bytes);

/// Parses a whole file. `fileName` is used in messages only.
/// Errors: ParseError (names file and line).
Result<PolygonMesh> readMesh(std::string_view bytes, MeshFormat format, std::string_view fileName);

/// Checks arrays that did not come from a file: index ranges, finite coordinates, face sizes.
/// Errors: InvalidMesh (names vertex or face).
Status validateArrays(const PolygonMesh& mesh);

/// OBJ text of the mesh with texcoords: the faces in their order, corner order and degree.
/// `uv` has 2 coordinates per texcoord, `cornerUv` the texcoord of each face corner (size of
/// faceVertices). When `sourceObj` is the OBJ text that `mesh` was read from, everything but
/// texcoords, what refers to them, and faces is copied from it byte for byte (positions, comments,
/// groups, materials, normals); otherwise positions are written so that they read back to the same
/// doubles.
std::string writeObj(const PolygonMesh& mesh, const std::vector<double>& uv,
                     const std::vector<std::uint32_t>& cornerUv, std::string_view sourceObj = {});

}  // namespace abflat
