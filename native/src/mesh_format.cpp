#include "mesh_format.h"

#include "paths.h"

namespace abflat::cli {

std::string formatName(MeshFormat format) {
  switch (format) {
    case MeshFormat::Obj:
      return "OBJ";
    case MeshFormat::Off:
      return "OFF";
    case MeshFormat::Ply:
      return "PLY";
    case MeshFormat::Stl:
      return "STL";
  }
  return {};
}

bool isWritableName(const std::string& path) {
  const std::string ending = endingOf(path);
  return ending.empty() || ending == ".obj" || ending == ".ply";
}

MeshFormat writtenFormat(const std::string& path) {
  return endingOf(path) == ".ply" ? MeshFormat::Ply : MeshFormat::Obj;
}

std::string layoutText(const InputMesh& input, const std::string& path,
                       const std::vector<double>& uv, const std::vector<std::uint32_t>& cornerUv) {
  const MeshFormat format = writtenFormat(path);
  const std::string_view source = input.format == format ? input.bytes : std::string_view();
  return format == MeshFormat::Ply ? writePly(input.mesh, uv, cornerUv, source)
                                   : writeObj(input.mesh, uv, cornerUv, source);
}

}  // namespace abflat::cli
