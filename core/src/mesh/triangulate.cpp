#include "mesh/triangulate.h"

#include <algorithm>
#include <array>
#include <utility>

#include "mesh/clip_ears.h"
#include "mesh/project_polygon.h"

namespace abflat {
namespace {

/// Whether the two triangles into which nearly every program splits a quad, (0, 1, 2) and (0, 2,
/// 3), are fine. Texcoords should suit those as well.
bool isFan(const std::vector<Point2>& quad, const std::vector<std::uint8_t>& keep) {
  if (keep[1] || keep[3]) return false;
  for (std::size_t k = 0; k < 4; ++k)
    if (!(turnOf(quad[k], quad[(k + 1) % 4], quad[(k + 2) % 4]) > 0)) return false;
  return true;
}

/// Vertices inside the mesh with only two faces. One that is cut off as an ear in both would have
/// only two triangles, which no flat mesh can have around an interior vertex.
std::vector<std::uint8_t> insideWithTwoFaces(const PolygonMesh& mesh) {
  struct Neighbours {
    std::uint32_t low = 0, high = 0;
    bool operator==(const Neighbours& o) const { return low == o.low && high == o.high; }
  };
  std::vector<Neighbours> first(mesh.vertexCount());
  std::vector<std::uint8_t> faces(mesh.vertexCount(), 0);
  constexpr std::uint8_t kOthers = 3;  // more faces, or two without the same neighbours
  for (PolygonFace f(0); f < mesh.faceCount(); ++f) {
    const std::uint32_t begin = mesh.faceOffsets[f], end = mesh.faceOffsets[f + 1];
    for (std::uint32_t c = begin; c < end; ++c) {
      const std::uint32_t v = mesh.faceVertices[c];
      const std::uint32_t a = mesh.faceVertices[c > begin ? c - 1 : end - 1];
      const std::uint32_t b = mesh.faceVertices[c + 1 < end ? c + 1 : begin];
      const Neighbours own{std::min(a, b), std::max(a, b)};
      if (faces[v] == 0) first[v] = own;
      faces[v] = faces[v] == 0 || (faces[v] == 1 && first[v] == own) ? faces[v] + 1 : kOthers;
    }
  }
  for (std::uint8_t& count : faces) count = count == 2;
  return faces;
}

/// `local`: corners of face f, counted from 0.
void appendTriangle(const PolygonMesh& mesh, PolygonFace f,
                    const std::array<std::uint32_t, 3>& local, Triangulation& out) {
  const std::uint32_t begin = mesh.faceOffsets[f], n = mesh.faceOffsets[f + 1] - begin;
  out.face.push_back(f);
  for (std::size_t k = 0; k < 3; ++k) {
    out.corner.push_back(PolygonCorner(begin + local[k]));
    out.vertex.push_back(InputVertex(mesh.faceVertices[begin + local[k]]));
    const std::uint32_t next = local[k] + 1 == n ? 0 : local[k] + 1;
    out.isDiagonal.push_back(next != local[(k + 1) % 3]);
  }
}

}  // namespace

Triangulation triangulate(const PolygonMesh& mesh, const Listener& listener) {
  Triangulation out;
  const std::size_t triangles = mesh.faceVertices.size() - 2 * mesh.faceCount();
  out.vertex.reserve(3 * triangles);
  out.corner.reserve(3 * triangles);
  out.isDiagonal.reserve(3 * triangles);
  out.face.reserve(triangles);
  std::vector<std::uint8_t> isKept;
  for (PolygonFace f(0); f < mesh.faceCount() && listener.beat(); ++f) {
    const std::uint32_t begin = mesh.faceOffsets[f], end = mesh.faceOffsets[f + 1], n = end - begin;
    if (n == 3) {
      appendTriangle(mesh, f, {0, 1, 2}, out);
      continue;
    }
    if (isKept.empty()) isKept = insideWithTwoFaces(mesh);
    std::vector<std::uint8_t> keep(n);
    for (std::uint32_t k = 0; k < n; ++k) keep[k] = isKept[mesh.faceVertices[begin + k]];
    std::vector<Point2> points = facePolygon(mesh.positions, &mesh.faceVertices[begin], n);
    if (n == 4 && isFan(points, keep)) {
      appendTriangle(mesh, f, {0, 1, 2}, out);
      appendTriangle(mesh, f, {0, 2, 3}, out);
      continue;
    }
    for (const auto& local : clipEars(std::move(points), keep, listener))
      appendTriangle(mesh, f, local, out);
  }
  return out;
}

}  // namespace abflat
