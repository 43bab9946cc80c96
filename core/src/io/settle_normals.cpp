#include "io/settle_normals.h"

#include <cmath>

namespace abflat {
namespace {

bool hasDirection(const double* n) {
  const bool isFinite = std::isfinite(n[0]) && std::isfinite(n[1]) && std::isfinite(n[2]);
  return isFinite && (n[0] != 0 || n[1] != 0 || n[2] != 0);
}

}  // namespace

void settleNormals(PolygonMesh& mesh) {
  const std::size_t count = mesh.normals.size() / 3;
  bool isUsed = false;
  for (std::uint32_t& n : mesh.faceNormals) {
    if (n >= count || !hasDirection(&mesh.normals[3 * std::size_t{n}]))
      n = kNoNormal;
    else
      isUsed = true;
  }
  if (isUsed) {
    mesh.faceNormals.resize(mesh.faceVertices.size(), kNoNormal);
    mesh.faceSmoothing = {};
  } else {
    mesh.normals = {};
    mesh.faceNormals = {};
  }
}

void takeVertexNormals(PolygonMesh& mesh) {
  if (!mesh.normals.empty()) mesh.faceNormals = mesh.faceVertices;
  settleNormals(mesh);
}

}  // namespace abflat
