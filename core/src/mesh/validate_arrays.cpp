#include <cmath>

#include "abflat/mesh.h"

namespace abflat {
namespace {

/// Checks what a mesh may have besides its faces.
Status validateExtras(const PolygonMesh& mesh) {
  const auto invalid = [](const std::string& sentence) {
    return Status{StatusCode::InvalidMesh, sentence};
  };
  if (mesh.texcoords.size() % 2 != 0)
    return invalid("the number of texcoord coordinates is not a multiple of 2");
  if (!mesh.faceTexcoords.empty() && mesh.faceTexcoords.size() != mesh.faceVertices.size())
    return invalid("every face corner needs one texcoord");
  if (!mesh.faceMaterials.empty() && mesh.faceMaterials.size() != mesh.faceCount())
    return invalid("every face needs one material");
  if (mesh.normals.size() % 3 != 0)
    return invalid("the number of coordinates of normals is not a multiple of 3");
  if (!mesh.faceNormals.empty() && mesh.faceNormals.size() != mesh.faceVertices.size())
    return invalid("every face corner needs one normal");
  if (!mesh.faceSmoothing.empty() && mesh.faceSmoothing.size() != mesh.faceCount())
    return invalid("every face needs one smoothing group");
  const std::size_t normals = mesh.normals.size() / 3;
  for (std::size_t c = 0; c < mesh.faceNormals.size(); ++c)
    if (mesh.faceNormals[c] != kNoNormal && mesh.faceNormals[c] >= normals)
      return invalid("face corner " + std::to_string(c) + " refers to normal " +
                     std::to_string(mesh.faceNormals[c]) + ", but there are only " +
                     std::to_string(normals) + " (indices start at 0)");
  const std::size_t count = mesh.texcoords.size() / 2;
  for (std::size_t c = 0; c < mesh.faceTexcoords.size(); ++c)
    if (mesh.faceTexcoords[c] != kNoTexcoord && mesh.faceTexcoords[c] >= count)
      return invalid("face corner " + std::to_string(c) + " refers to texcoord " +
                     std::to_string(mesh.faceTexcoords[c]) + ", but there are only " +
                     std::to_string(count) + " (indices start at 0)");
  return {};
}

}  // namespace

Status validateArrays(const PolygonMesh& mesh) {
  const auto invalid = [](const std::string& sentence) {
    return Status{StatusCode::InvalidMesh, sentence};
  };
  if (mesh.positions.size() % 3 != 0)
    return invalid("the number of coordinates is not a multiple of 3");
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    if (!std::isfinite(mesh.positions[i]))
      return invalid("vertex " + std::to_string(i / 3) + " has a coordinate that is not finite");
  if (mesh.faceOffsets.empty()
          ? !mesh.faceVertices.empty()
          : mesh.faceOffsets.front() != 0 || mesh.faceOffsets.back() != mesh.faceVertices.size())
    return invalid("the face offsets do not cover the face corners");
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    const std::uint32_t begin = mesh.faceOffsets[f], end = mesh.faceOffsets[f + 1];
    if (end < begin + 3 || end < begin)
      return invalid("face " + std::to_string(f) + " has fewer than 3 corners");
    for (std::uint32_t c = begin; c < end && c < mesh.faceVertices.size(); ++c)
      if (mesh.faceVertices[c] >= mesh.vertexCount())
        return invalid("face " + std::to_string(f) + " refers to vertex " +
                       std::to_string(mesh.faceVertices[c]) + ", but there are only " +
                       std::to_string(mesh.vertexCount()) + " vertices (indices start at 0)");
  }
  return validateExtras(mesh);
}

}  // namespace abflat
