#include "io/settle_texcoords.h"

#include <cmath>

namespace abflat {

void settleTexcoords(PolygonMesh& mesh) {
  const std::size_t count = mesh.texcoords.size() / 2;
  bool isUsed = false;
  for (std::uint32_t& t : mesh.faceTexcoords) {
    const std::size_t at = 2 * static_cast<std::size_t>(t);
    if (t >= count || !std::isfinite(mesh.texcoords[at]) || !std::isfinite(mesh.texcoords[at + 1]))
      t = kNoTexcoord;
    else
      isUsed = true;
  }
  if (isUsed) {
    mesh.faceTexcoords.resize(mesh.faceVertices.size(), kNoTexcoord);
  } else {
    mesh.texcoords = {};
    mesh.faceTexcoords = {};
  }
}

}  // namespace abflat
