#include "baking/obj_corners.h"

#include <map>
#include <utility>

#include "abflat/corner_frames.h"

namespace abflat::cli {
namespace {

/// v of an OBJ points up, that of images down.
void put(const std::vector<double>& uv, std::uint32_t index, std::vector<double>& out) {
  const bool isMapped = index != kNoTexcoord;
  out.push_back(isMapped ? uv[2 * std::size_t{index}] : 0);
  out.push_back(isMapped ? 1 - uv[2 * std::size_t{index} + 1] : 0);
}

/// Vertices of their own for each normal.
struct ShadedVertices {
  std::vector<std::uint32_t> ofCorner;
  std::vector<double> positions;
  std::vector<float> normals;

  ShadedVertices(const PolygonMesh& mesh, const std::vector<std::uint32_t>& corners) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> known;
    for (const std::uint32_t c : corners) {
      const std::uint32_t v = mesh.faceVertices[c];
      const std::uint32_t n = mesh.faceNormals.empty() ? kNoNormal : mesh.faceNormals[c];
      const auto [place, isNew] =
          known.emplace(std::pair(v, n), static_cast<std::uint32_t>(known.size()));
      ofCorner.push_back(place->second);
      for (std::size_t d = 0; d < 3 && isNew; ++d) {
        positions.push_back(mesh.positions[3 * std::size_t{v} + d]);
        normals.push_back(
            n == kNoNormal ? 0 : static_cast<float>(mesh.normals[3 * std::size_t{n} + d]));
      }
    }
  }
};

}  // namespace

ObjCorners::ObjCorners(const PolygonMesh& mesh, const NewLayout& layout,
                       const std::vector<std::uint32_t>& triangleCorners)
    : mesh_(mesh), layout_(layout), corners_(triangleCorners) {
  std::uint32_t face = 0;
  for (std::size_t c = 0; c < corners_.size(); c += 3) {
    while (mesh.faceOffsets[face + 1] <= corners_[c]) ++face;
    faces_.push_back(face);
  }
}

BakeTriangles ObjCorners::triangles() const {
  BakeTriangles out;
  for (const std::uint32_t c : corners_) {
    put(layout_.uv, layout_.ofCorner[c], out.uv);
    put(mesh_.texcoords, mesh_.faceTexcoords.empty() ? kNoTexcoord : mesh_.faceTexcoords[c],
        out.oldUv);
  }
  for (const std::uint32_t face : faces_)
    out.materials.push_back(mesh_.faceMaterials.empty() ? 0 : mesh_.faceMaterials[face]);
  return out;
}

std::vector<float> ObjCorners::colours(const std::vector<double>& ofVertices) const {
  std::vector<float> out;
  out.reserve(4 * corners_.size());
  for (const std::uint32_t c : corners_)
    for (std::size_t d = 0; d < 4; ++d)
      out.push_back(static_cast<float>(ofVertices[4 * std::size_t{mesh_.faceVertices[c]} + d]));
  return out;
}

void ObjCorners::addFrames(BakeTriangles& triangles) const {
  const ShadedVertices vertices(mesh_, corners_);
  std::vector<bool> isTurnedFace(mesh_.faceCount()), isTurned;
  for (const std::uint32_t face : layout_.turnedFaces) isTurnedFace[face] = true;
  for (const std::uint32_t face : faces_) isTurned.push_back(isTurnedFace[face]);
  std::vector<std::uint32_t> before = vertices.ofCorner;
  for (std::size_t t = 0; t < faces_.size(); ++t)
    if (isTurned[t]) std::swap(before[3 * t + 1], before[3 * t + 2]);
  const std::vector<float> noTangents;
  FrameMesh frames{before, isTurned, vertices.positions, vertices.normals, noTangents, {}};
  frames.parts.push_back({0, static_cast<std::uint32_t>(faces_.size()), false, false});
  triangles.normals = cornerNormals(frames);
  triangles.oldTangents = oldTangents(frames, triangles.oldUv, triangles.normals);
  triangles.tangents = newTangents(frames, triangles.uv, triangles.normals);
}

}  // namespace abflat::cli
