#include "io/ply_texcoords.h"

#include "io/settle_texcoords.h"

namespace abflat {

void appendTexcoords(const std::vector<double>& uv, PolygonMesh& mesh) {
  const std::size_t before = mesh.faceTexcoords.size();
  const std::size_t corners = mesh.faceVertices.size() - before;
  if (uv.size() != 2 * corners) {
    mesh.faceTexcoords.resize(mesh.faceVertices.size(), kNoTexcoord);
    return;
  }
  for (std::size_t k = 0; k < corners; ++k)
    mesh.faceTexcoords.push_back(static_cast<std::uint32_t>(mesh.texcoords.size() / 2 + k));
  mesh.texcoords.insert(mesh.texcoords.end(), uv.begin(), uv.end());
}

void finishTexcoords(const PlyHeader& header, PolygonMesh& mesh) {
  if (header.cornerTexcoords == kNoIndex && header.u != kNoIndex)
    mesh.faceTexcoords = mesh.faceVertices;
  settleTexcoords(mesh);
}

}  // namespace abflat
