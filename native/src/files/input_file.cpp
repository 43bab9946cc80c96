#include "files/input_file.h"

#include <utility>

#include "files/file_format.h"
#include "files/out_of_memory.h"
#include "files/paths.h"
#include "files/read_file.h"
#include "files/resources.h"

namespace abflat::cli {
namespace {

/// Decided by the extension, or by the first bytes if that tells nothing.
bool isGltf(const std::string& path, std::string_view bytes) {
  const std::optional<FileFormat> named = namedFormat(path);
  return named ? *named == FileFormat::Gltf : looksLikeGltf(bytes);
}

Status readGltfInput(const std::string& path, const GltfReadOptions& options, InputFile& input) {
  Result<GltfModel> model = readGltf(input.bytes, inputName(path), input.readResource, options);
  if (!model.ok()) return model.status();
  std::string().swap(input.bytes);
  input.format = FileFormat::Gltf;
  input.mesh = std::move(model.value().mesh);
  input.notes = std::move(model.value().notes);
  input.gltf = std::move(model.value().source);
  return {};
}

void joinRepeated(InputFile& input) {
  const std::size_t joined = joinVertices(input.mesh);
  if (joined > 0)
    input.notes.push_back(std::to_string(joined) +
                          (joined == 1 ? " duplicate vertex was" : " duplicate vertices were") +
                          " treated as one");
}

Status readMeshInput(const std::string& path, InputFile& input) {
  const std::string name = inputName(path);
  const Result<MeshFormat> format = detectFormat(name, input.bytes);
  if (!format.ok() && input.bytes.empty()) return format.status();
  if (!format.ok()) return {format.status().code, name + " is not supported. Use " + kFormatNames};
  input.format = static_cast<FileFormat>(format.value());
  Result<PolygonMesh> mesh = readMesh(input.bytes, format.value(), name);
  if (!mesh.ok()) return mesh.status();
  input.mesh = std::move(mesh.value());
  return {};
}

}  // namespace

Result<InputFile> readInput(const std::string& path, const ReadOptions& options) {
  return orOutOfMemory(inputName(path), [&]() -> Result<InputFile> {
    InputFile out;
    out.path = path;
    out.readResource = resourcesOf(path, options.allowsOutside);
    Result<std::string> bytes = readBytes(path);
    if (!bytes.ok()) return bytes.status();
    out.bytes = std::move(bytes.value());
    const Status status =
        isGltf(path, out.bytes) ? readGltfInput(path, options.gltf, out) : readMeshInput(path, out);
    if (!status.ok()) return status;
    if (out.gltf && options.repeated == Repeated::Join) joinRepeated(out);
    return out;
  });
}

Status readLook(InputFile& input) {
  const std::optional<MeshFormat> ofCore = coreFormat(input.format);
  if (!ofCore) return {};
  Result<Appearance> look = readAppearance(input.bytes, *ofCore, input.mesh, input.readResource);
  if (look.ok()) input.look = std::move(look.value());
  return look.status();
}

}  // namespace abflat::cli
