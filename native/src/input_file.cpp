#include "input_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>

#include "arguments.h"
#include "out_of_memory.h"
#include "paths.h"

namespace abflat::cli {
namespace {

/// Beyond the size that a file claims: enough to see its end, and to begin with where it claims
/// none.
constexpr std::size_t kSpare = 1 << 12;

/// Empty, or why it failed.
std::string readAll(int file, std::string& bytes) {
  struct stat info {};
  std::size_t claimed = 0;
  if (fstat(file, &info) == 0) {
    if (S_ISDIR(info.st_mode)) return "it is a folder";
    if (S_ISREG(info.st_mode)) claimed = static_cast<std::size_t>(info.st_size);
  }
  bytes.resize(claimed + kSpare);
  for (std::size_t size = 0;;) {
    if (size == bytes.size()) bytes.resize(2 * size);
    const ssize_t got = ::read(file, &bytes[size], bytes.size() - size);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return std::strerror(errno);
    size += static_cast<std::size_t>(got);
    if (got > 0) continue;
    bytes.resize(size);
    return {};
  }
}

FileFormat fileFormat(MeshFormat format) {
  switch (format) {
    case MeshFormat::Obj:
      return FileFormat::Obj;
    case MeshFormat::Off:
      return FileFormat::Off;
    case MeshFormat::Ply:
      return FileFormat::Ply;
    case MeshFormat::Stl:
      return FileFormat::Stl;
  }
  return FileFormat::Obj;
}

/// Of a file that is no glTF.
MeshFormat meshFormat(FileFormat format) {
  for (const MeshFormat known :
       {MeshFormat::Obj, MeshFormat::Off, MeshFormat::Ply, MeshFormat::Stl})
    if (fileFormat(known) == format) return known;
  return MeshFormat::Obj;
}

/// By its ending, or by its first bytes where that says nothing.
bool isGltf(const std::string& path, std::string_view bytes) {
  const std::string ending = endingOf(path);
  if (ending == ".glb" || ending == ".gltf") return true;
  const bool isOther = ending == ".obj" || ending == ".ply" || ending == ".stl" || ending == ".off";
  return !isOther && looksLikeGltf(bytes);
}

/// Files that are named relative to the one at `path`.
ReadResource readBeside(const std::string& path) {
  namespace fs = std::filesystem;
  return [folder = fs::path(path).parent_path()](const std::string& name) -> Result<std::string> {
    const std::string file = (folder / name).string();
    std::error_code ignored;  // readBytes says what is wrong
    if (fs::is_other(file, ignored))
      return Status{StatusCode::UnreadableFile,
                    "cannot read " + file + ": it is a device or a pipe"};
    return readBytes(file);
  };
}

Status readGltfInput(const std::string& path, InputMesh& input) {
  Result<GltfModel> model = readGltf(input.bytes, inputName(path), readBeside(path));
  if (!model.ok()) return model.status;
  std::string().swap(input.bytes);
  input.format = FileFormat::Gltf;
  input.mesh = std::move(model.value.mesh);
  input.notes = std::move(model.value.notes);
  input.gltf = std::move(model.value.source);
  return {};
}

void joinRepeated(InputMesh& input) {
  const std::size_t joined = joinVertices(input.mesh);
  if (joined > 0)
    input.notes.push_back(std::to_string(joined) + (joined == 1 ? " vertex is" : " vertices are") +
                          " taken as the one at the same place");
}

Status readMeshInput(const std::string& path, InputMesh& input) {
  const std::string name = inputName(path);
  const Result<MeshFormat> format = detectFormat(name, input.bytes);
  if (!format.ok() && input.bytes.empty()) return format.status;
  if (!format.ok()) return {format.status.code, name + ": not an OBJ, PLY, STL, OFF or glTF file"};
  input.format = fileFormat(format.value);
  Result<PolygonMesh> mesh = readMesh(input.bytes, format.value, name);
  input.mesh = std::move(mesh.value);
  return mesh.status;
}

}  // namespace

Result<std::string> readBytes(const std::string& path) {
  const bool isStandard = path == kStandardStream;
  const auto failure = [&](const std::string& reason) {
    return Status{StatusCode::UnreadableFile, "cannot read " + inputName(path) + ": " + reason};
  };
  const int file = isStandard ? STDIN_FILENO : open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return failure(std::strerror(errno));
  std::string bytes;
  const std::string problem = readAll(file, bytes);
  if (!isStandard) close(file);  // nothing was written, so nothing can get lost
  if (!problem.empty()) return failure(problem);
  return bytes;
}

Result<InputMesh> readInput(const std::string& path, Repeated repeated) {
  return orOutOfMemory(inputName(path), [&]() -> Result<InputMesh> {
    InputMesh out;
    out.path = path;
    Result<std::string> bytes = readBytes(path);
    if (!bytes.ok()) return bytes.status;
    out.bytes = std::move(bytes.value);
    const Status status =
        isGltf(path, out.bytes) ? readGltfInput(path, out) : readMeshInput(path, out);
    if (!status.ok()) return status;
    if (out.gltf && repeated == Repeated::Join) joinRepeated(out);
    return out;
  });
}

void readLook(InputMesh& input) {
  if (!input.gltf)
    input.look =
        readAppearance(input.bytes, meshFormat(input.format), input.mesh, readBeside(input.path));
}

}  // namespace abflat::cli
