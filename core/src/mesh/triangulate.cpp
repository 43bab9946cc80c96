#include "mesh/triangulate.h"

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

/// A vertex with two faces that is cut off as an ear in both would have only two triangles, which
/// no flat mesh can have around an interior vertex.
std::vector<std::uint8_t> facesPerVertex(const PolygonMesh& mesh) {
  std::vector<std::uint8_t> count(mesh.vertexCount(), 0);
  for (std::uint32_t v : mesh.faceVertices)
    if (count[v] < 3) ++count[v];
  return count;
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

Triangulation triangulate(const PolygonMesh& mesh, const Pulse& pulse) {
  Triangulation out;
  const std::size_t triangles = mesh.faceVertices.size() - 2 * mesh.faceCount();
  out.vertex.reserve(3 * triangles);
  out.corner.reserve(3 * triangles);
  out.isDiagonal.reserve(3 * triangles);
  out.face.reserve(triangles);
  std::vector<std::uint8_t> valence;
  for (PolygonFace f(0); f < mesh.faceCount() && pulse.beat(); ++f) {
    const std::uint32_t begin = mesh.faceOffsets[f], end = mesh.faceOffsets[f + 1], n = end - begin;
    if (n == 3) {
      appendTriangle(mesh, f, {0, 1, 2}, out);
      continue;
    }
    if (valence.empty()) valence = facesPerVertex(mesh);
    std::vector<std::uint8_t> keep(n);
    for (std::uint32_t k = 0; k < n; ++k) keep[k] = valence[mesh.faceVertices[begin + k]] == 2;
    std::vector<Point2> points = projectPolygon(mesh.positions, &mesh.faceVertices[begin], n);
    if (n == 4 && isFan(points, keep)) {
      appendTriangle(mesh, f, {0, 1, 2}, out);
      appendTriangle(mesh, f, {0, 2, 3}, out);
      continue;
    }
    for (const auto& local : clipEars(std::move(points), keep, pulse))
      appendTriangle(mesh, f, local, out);
  }
  return out;
}

}  // namespace abflat
