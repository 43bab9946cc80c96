#include "mesh/triangulate.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace abflat {
namespace {

using Point2 = std::array<double, 2>;

double cross(const Point2& a, const Point2& b, const Point2& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

double squaredDistance(const Point2& a, const Point2& b) {
  return (a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]);
}

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

class EarClipper {
 public:
  EarClipper(std::vector<Point2> points, const std::vector<std::uint8_t>& keep)
      : points_(std::move(points)), keep_(keep), ring_(points_.size()) {
    for (std::size_t k = 0; k < ring_.size(); ++k) ring_[k] = static_cast<std::uint32_t>(k);
  }

  /// Triangles as local corner indices.
  std::vector<std::array<std::uint32_t, 3>> run() {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    while (ring_.size() > 3) {
      const std::size_t ear = pickEar();
      triangles.push_back({at(ear + ring_.size() - 1), at(ear), at(ear + 1)});
      ring_.erase(ring_.begin() + static_cast<std::ptrdiff_t>(ear));
    }
    triangles.push_back({ring_[0], ring_[1], ring_[2]});
    return triangles;
  }

 private:
  std::uint32_t at(std::size_t i) const { return ring_[i % ring_.size()]; }

  /// Large faces take the first acceptable ear so that clipping stays quadratic.
  std::size_t pickEar() const {
    constexpr std::size_t kSearchBestUpTo = 64;
    std::size_t best = 0;
    double bestQuality = -1e300;
    for (std::size_t i = 0; i < ring_.size(); ++i) {
      const double q = quality(i);
      if (q <= bestQuality) continue;
      bestQuality = q;
      best = i;
      if (ring_.size() > kSearchBestUpTo && q > 0.1) break;
    }
    return best;
  }

  /// In (0, 1] for a proper ear, larger is rounder; below 0 where the ear is reflex, flat or not
  /// empty.
  double quality(std::size_t i) const {
    const Point2& a = points_[at(i + ring_.size() - 1)];
    const Point2& b = points_[at(i)];
    const Point2& c = points_[at(i + 1)];
    const double edges = squaredDistance(a, b) + squaredDistance(b, c) + squaredDistance(c, a);
    double q = edges > 0 ? cross(a, b, c) * 2 * std::sqrt(3.0) / edges : 0;
    if (!(q > 0)) return q - 2;
    if (!isEmpty(i, a, b, c)) q -= 2;
    if (keep_[at(i)]) q -= 1;
    return q;
  }

  bool isEmpty(std::size_t i, const Point2& a, const Point2& b, const Point2& c) const {
    for (std::size_t j = 2; j + 1 < ring_.size(); ++j) {
      const Point2& p = points_[at(i + j)];
      if (p == a || p == b || p == c) continue;
      if (cross(a, b, p) >= 0 && cross(b, c, p) >= 0 && cross(c, a, p) >= 0) return false;
    }
    return true;
  }

  std::vector<Point2> points_;
  const std::vector<std::uint8_t>& keep_;  ///< corners that should not become ears
  std::vector<std::uint32_t> ring_;
};

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
    for (const auto& local : EarClipper(projectFace(mesh, begin, end), keep).run())
      appendTriangle(mesh, f, local, out);
  }
  return out;
}

}  // namespace abflat
