#include <cmath>

#include "abflat/mesh.h"
#include "base/ids.h"
#include "mesh/input_mesh.h"

namespace abflat {
namespace {

Status invalidMesh(const std::string& sentence) { return {StatusCode::InvalidMesh, sentence}; }

/// Checks what face corners refer to: `numbers` has `size` coordinates for each.
Status validateCorners(const PolygonMesh& mesh, const std::vector<std::uint32_t>& ofCorner,
                       const std::vector<double>& numbers, std::size_t size,
                       const std::string& name) {
  if (numbers.size() % size != 0)
    return invalidMesh("the number of " + name + " coordinates is not a multiple of " +
                       std::to_string(size));
  if (!ofCorner.empty() && ofCorner.size() != mesh.faceVertices.size())
    return invalidMesh("every face corner needs one " + name);
  const std::size_t count = numbers.size() / size;
  static_assert(kNoTexcoord == kNoNormal, "both mean none");
  for (std::size_t c = 0; c < ofCorner.size(); ++c)
    if (ofCorner[c] != kNoTexcoord && ofCorner[c] >= count)
      return invalidMesh("face corner " + std::to_string(c) + " refers to " + name + " " +
                         std::to_string(ofCorner[c]) + ", but there are only " +
                         std::to_string(count) + " (indices start at 0)");
  return {};
}

/// Checks what a mesh may have besides its faces.
Status validateExtras(const PolygonMesh& mesh) {
  if (Status s = validateCorners(mesh, mesh.faceTexcoords, mesh.texcoords, 2, "texcoord"); !s.ok())
    return s;
  const auto isEach = [](const std::vector<std::uint32_t>& numbers, std::size_t count) {
    return numbers.empty() || numbers.size() == count;
  };
  const char* const missing =
      !isEach(mesh.faceMaterials, mesh.faceCount())     ? "every face needs one material"
      : !isEach(mesh.faceSmoothing, mesh.faceCount())   ? "every face needs one smoothing group"
      : !isEach(mesh.vertexObjects, mesh.vertexCount()) ? "every vertex needs one object"
                                                        : nullptr;
  if (missing) return invalidMesh(missing);
  return validateCorners(mesh, mesh.faceNormals, mesh.normals, 3, "normal");
}

Status notFinite(std::size_t vertex) {
  return invalidMesh("vertex " + std::to_string(vertex) + " has a coordinate that is not finite");
}

Status noSuchVertex(std::size_t face, std::uint64_t vertex, std::size_t vertices) {
  return invalidMesh("face " + std::to_string(face) + " refers to vertex " +
                     std::to_string(vertex) + ", but there are only " + std::to_string(vertices) +
                     " vertices (indices start at 0)");
}

Status validateView(const MeshView& mesh) {
  const std::size_t vertices = mesh.positions.size();
  if (vertices > kNone || mesh.triangles.size() > kNone / 3)
    return invalidMesh("the mesh has more than 4294967295 vertices or face corners");
  for (std::size_t v = 0; v < vertices; ++v)
    for (const double x : mesh.positions[v])
      if (!std::isfinite(x)) return notFinite(v);
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k)
      if (const std::uint64_t v = mesh.triangles.vertex(f, k); v >= vertices)
        return noSuchVertex(f, v, vertices);
  return {};
}

}  // namespace

Status validateArrays(const PolygonMesh& mesh) {
  if (mesh.positions.size() % 3 != 0)
    return invalidMesh("the number of coordinates is not a multiple of 3");
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    if (!std::isfinite(mesh.positions[i])) return notFinite(i / 3);
  if (mesh.faceOffsets.empty()
          ? !mesh.faceVertices.empty()
          : mesh.faceOffsets.front() != 0 || mesh.faceOffsets.back() != mesh.faceVertices.size())
    return invalidMesh("the face offsets do not cover the face corners");
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    const std::uint32_t begin = mesh.faceOffsets[f], end = mesh.faceOffsets[f + 1];
    if (end < begin + 3 || end < begin)
      return invalidMesh("face " + std::to_string(f) + " has fewer than 3 corners");
    for (std::uint32_t c = begin; c < end && c < mesh.faceVertices.size(); ++c)
      if (mesh.faceVertices[c] >= mesh.vertexCount())
        return noSuchVertex(f, mesh.faceVertices[c], mesh.vertexCount());
  }
  return validateExtras(mesh);
}

Status InputMesh::validate() const {
  return polygons_ ? validateArrays(*polygons_) : validateView(*view_);
}

}  // namespace abflat
