// Generated from core/schema by scripts/generate.mjs, do not edit.
// clang-format off
#pragma once

namespace abflat {

/// The formats that readMesh reads; those that writeMesh writes come first.
enum class MeshFormat : int {
  Obj = 0,  ///< Wavefront OBJ, text
  Ply = 1,  ///< polygons with any properties, text or binary
  Stl = 2,  ///< triangles without connectivity, text or binary
  Off = 3,  ///< polygons, text or binary
};

constexpr int kMeshFormatCount = 4;
constexpr int kWrittenFormatCount = 2;

/// For messages.
#define ABFLAT_MESH_FORMATS "OBJ, PLY, STL or OFF"

/// How names of files end, in lower case.
struct MeshEnding {
  const char* ending;
  MeshFormat format;
};

constexpr MeshEnding kMeshEndings[] = {
    {".obj", MeshFormat::Obj},
    {".ply", MeshFormat::Ply},
    {".stl", MeshFormat::Stl},
    {".off", MeshFormat::Off},
};

/// How exactly a written file holds texcoords.
enum class Precision {
  None,    ///< it is not written
  Double,
  Single,
  Gltf     ///< single, with v from the top
};

constexpr Precision precisionOf(MeshFormat code) {
  switch (code) {
    case MeshFormat::Obj:
      return Precision::Double;
    case MeshFormat::Ply:
      return Precision::Single;
    case MeshFormat::Stl:
    case MeshFormat::Off:
      return Precision::None;
  }
  return Precision::None;
}

}  // namespace abflat
