#pragma once

#include <string>
#include <vector>

#include "abflat/appearance.h"
#include "abflat/gltf.h"
#include "abflat/io.h"
#include "files/file_format.h"

namespace abflat::cli {

/// The mesh to work on, and whatever else its file has.
struct InputFile {
  std::string bytes;  ///< empty for a glTF, since `gltf` holds them
  FileFormat format = FileFormat::Obj;
  PolygonMesh mesh;
  std::vector<std::string> notes;  ///< what is not in the mesh, one sentence each
  std::shared_ptr<const gltf::Source> gltf;
  Appearance look;  ///< of other formats, once readLook has been called
  std::string path;
  ReadResource readResource;  ///< reads files that it refers to
};

/// How to treat vertices that a glTF repeats where normals or texcoords change.
enum class Repeated {
  Stay,
  Join  ///< unless the mesh is already a disk
};

struct ReadOptions {
  Repeated repeated = Repeated::Join;
  bool allowsOutside = false;  ///< files that the mesh refers to may be anywhere
  GltfReadOptions gltf = {};
};

/// Reads a mesh from a file together with the files that it refers to, or from standard input if
/// `path` is "-". Errors: UnreadableFile, ParseError, OutOfMemory; messages name the file.
Result<InputFile> readInput(const std::string& path, const ReadOptions& options);

/// Reads what a glTF can store of the mesh beyond its shape, also from files that the input refers
/// to. Does nothing for a glTF, which already has that.
Status readLook(InputFile& input);

}  // namespace abflat::cli
