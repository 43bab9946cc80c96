#include "files/layout_text.h"

#include <filesystem>

#include "files/file_format.h"
#include "files/paths.h"

namespace abflat::cli {
namespace {

/// The path from the folder of one file to that of another; empty if they are the same.
std::string pathBetween(const std::string& from, const std::string& to) {
  namespace fs = std::filesystem;
  if (from == kStandardStream || to == kStandardStream) return {};
  std::error_code ignored;  // a folder that cannot be looked up is compared as written
  const auto folder = [&](const std::string& path) {
    return fs::weakly_canonical(fs::absolute(path, ignored), ignored).parent_path();
  };
  const std::string out = folder(to).lexically_relative(folder(from)).generic_string();
  return out == "." ? "" : out;
}

}  // namespace

Result<std::string> layoutText(const InputFile& input, const std::string& path, std::size_t set,
                               const WrittenLayout& now) {
  const FileFormat format = writtenFormat(path);
  const std::string_view source = input.format == format ? input.bytes : std::string_view();
  if (const std::optional<MeshFormat> ofCore = coreFormat(format))
    return writeMesh(*ofCore, input.mesh, now.uv, now.ofCorner, source, now.turnedFaces);
  const bool isBinary = endingOf(path) == ".glb";
  if (!input.gltf)
    return makeGltf(input.mesh, now.uv, now.ofCorner, now.triangleCorners, input.look,
                    {isBinary, set, now.isMadeBaked});
  GltfWriteOptions options;
  options.isBinary = isBinary;
  options.texcoord = set;
  options.turnedFaces = now.turnedFaces;
  options.baked = now.baked;
  options.pathToSource = pathBetween(path, input.path);
  return writeGltf(*input.gltf, now.uv, now.ofCorner, options);
}

}  // namespace abflat::cli
