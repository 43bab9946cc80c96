#include "io/format_functions.h"

namespace abflat {

std::string writeMesh(MeshFormat format, const PolygonMesh& mesh, const std::vector<double>& uv,
                      const std::vector<std::uint32_t>& cornerUv, std::string_view source,
                      const std::vector<std::uint32_t>& turnedFaces) {
  const auto write = functionsOf(format).write;
  return write ? write(mesh, uv, cornerUv, source, turnedFaces) : std::string();
}

}  // namespace abflat
