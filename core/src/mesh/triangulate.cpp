#include "mesh/triangulate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "mesh/clip_ears.h"

namespace abflat {
namespace {

using Point2 = std::array<double, 2>;

/// The face's corners in its own plane, counter-clockwise, scaled to about unit size.
std::vector<Point2> projectFace(const PolygonMesh& mesh, std::uint32_t begin, std::uint32_t end) {
  const double* origin = &mesh.positions[3 * mesh.faceVertices[begin]];
  std::vector<std::array<double, 3>> p(end - begin);
  double size = 0;
  for (std::uint32_t k = begin; k < end; ++k)
    for (std::size_t d = 0; d < 3; ++d) {
      p[k - begin][d] = mesh.positions[3 * mesh.faceVertices[k] + d] - origin[d];
      size = std::max(size, std::abs(p[k - begin][d]));
    }
  std::array<double, 3> normal{0, 0, 0};
  for (std::size_t k = 0; k < p.size(); ++k) {
    for (double& x : p[k])
      if (size > 0) x /= size;
    if (k == 0) continue;
    const auto& a = p[k - 1];
    const auto& b = p[k];
    for (std::size_t d = 0; d < 3; ++d)
      normal[d] += a[(d + 1) % 3] * b[(d + 2) % 3] - a[(d + 2) % 3] * b[(d + 1) % 3];
  }
  // Dropping the coordinate of the largest normal component keeps orientation and convexity.
  std::size_t drop = 0;
  for (std::size_t d = 1; d < 3; ++d)
    if (std::abs(normal[d]) > std::abs(normal[drop])) drop = d;
  const bool flip = normal[drop] < 0;
  std::vector<Point2> q(p.size());
  for (std::size_t k = 0; k < p.size(); ++k) {
    q[k] = {p[k][(drop + 1) % 3], p[k][(drop + 2) % 3]};
    if (flip) std::swap(q[k][0], q[k][1]);
  }
  return q;
}

/// Whether the two triangles that nearly every program makes of a quad, (0, 1, 2) and (0, 2, 3),
/// are fine: texcoords should suit them, too.
bool isFan(const std::vector<Point2>& quad, const std::vector<std::uint8_t>& keep) {
  if (keep[1] || keep[3]) return false;
  for (std::size_t k = 0; k < 4; ++k)
    if (!(turnOf(quad[k], quad[(k + 1) % 4], quad[(k + 2) % 4]) > 0)) return false;
  return true;
}

/// A vertex with two faces that is cut off as an ear in both would be left with two triangles,
/// which no flat mesh can have round an interior vertex.
std::vector<std::uint8_t> facesPerVertex(const PolygonMesh& mesh) {
  std::vector<std::uint8_t> count(mesh.vertexCount(), 0);
  for (std::uint32_t v : mesh.faceVertices)
    if (count[v] < 3) ++count[v];
  return count;
}

/// `local`: corners of face f, counted from 0.
void appendTriangle(const PolygonMesh& mesh, std::uint32_t f,
                    const std::array<std::uint32_t, 3>& local, Triangulation& out) {
  const std::uint32_t begin = mesh.faceOffsets[f], n = mesh.faceOffsets[f + 1] - begin;
  out.face.push_back(f);
  for (std::size_t k = 0; k < 3; ++k) {
    out.corner.push_back(begin + local[k]);
    out.vertex.push_back(mesh.faceVertices[begin + local[k]]);
    const std::uint32_t next = local[k] + 1 == n ? 0 : local[k] + 1;
    out.isDiagonal.push_back(next != local[(k + 1) % 3]);
  }
}

}  // namespace

Triangulation triangulate(const PolygonMesh& mesh) {
  Triangulation out;
  const std::size_t triangles = mesh.faceVertices.size() - 2 * mesh.faceCount();
  out.vertex.reserve(3 * triangles);
  out.corner.reserve(3 * triangles);
  out.isDiagonal.reserve(3 * triangles);
  out.face.reserve(triangles);
  std::vector<std::uint8_t> valence;
  for (std::uint32_t f = 0; f < mesh.faceCount(); ++f) {
    const std::uint32_t begin = mesh.faceOffsets[f], end = mesh.faceOffsets[f + 1], n = end - begin;
    if (n == 3) {
      appendTriangle(mesh, f, {0, 1, 2}, out);
      continue;
    }
    if (valence.empty()) valence = facesPerVertex(mesh);
    std::vector<std::uint8_t> keep(n);
    for (std::uint32_t k = 0; k < n; ++k) keep[k] = valence[mesh.faceVertices[begin + k]] == 2;
    std::vector<Point2> points = projectFace(mesh, begin, end);
    if (n == 4 && isFan(points, keep)) {
      appendTriangle(mesh, f, {0, 1, 2}, out);
      appendTriangle(mesh, f, {0, 2, 3}, out);
      continue;
    }
    for (const auto& local : clipEars(std::move(points), keep)) appendTriangle(mesh, f, local, out);
  }
  return out;
}

}  // namespace abflat
