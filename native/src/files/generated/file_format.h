// Generated from core/schema by scripts/generate.mjs, do not edit.
// clang-format off
#pragma once

#include "abflat/generated/mesh_format.h"

namespace abflat::cli {

/// All formats; those of the core come first, with its numbers.
enum class FileFormat : int {
  Obj = 0,  ///< Wavefront OBJ, text
  Ply = 1,  ///< polygons with any properties, text or binary
  Stl = 2,  ///< triangles without connectivity, text or binary
  Off = 3,  ///< polygons, text or binary
  Gltf = 4,  ///< glTF 2.0
};

/// "OBJ"
inline const char* titleOf(FileFormat code) {
  switch (code) {
    case FileFormat::Obj:
      return "OBJ";
    case FileFormat::Ply:
      return "PLY";
    case FileFormat::Stl:
      return "STL";
    case FileFormat::Off:
      return "OFF";
    case FileFormat::Gltf:
      return "glTF";
  }
  return "";
}

/// What is written where no name tells.
constexpr FileFormat kUnnamedFormat = FileFormat::Obj;

/// How names of files end, in lower case.
struct FileEnding {
  const char* ending;
  FileFormat format;
};

constexpr FileEnding kFileEndings[] = {
    {".obj", FileFormat::Obj},
    {".ply", FileFormat::Ply},
    {".stl", FileFormat::Stl},
    {".off", FileFormat::Off},
    {".glb", FileFormat::Gltf},
    {".gltf", FileFormat::Gltf},
};

constexpr Precision precisionOf(FileFormat code) {
  switch (code) {
    case FileFormat::Obj:
      return Precision::Double;
    case FileFormat::Ply:
      return Precision::Single;
    case FileFormat::Stl:
    case FileFormat::Off:
      return Precision::None;
    case FileFormat::Gltf:
      return Precision::Gltf;
  }
  return Precision::None;
}

// For messages and the help.
constexpr const char* kFormatTitles = "OBJ, PLY, STL, OFF or glTF";
constexpr const char* kFormatNames = "OBJ, PLY, STL, OFF, glTF or GLB";
constexpr const char* kWrittenEndings = ".obj, .ply, .glb or .gltf";
constexpr const char* kCoreTitles = "OBJ, PLY, STL and OFF";
constexpr const char* kCoreEndings = ".obj, .ply, .stl or .off";

}  // namespace abflat::cli
