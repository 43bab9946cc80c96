#include "mesh/triangulate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>
#include <utility>

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

/// Cuts off the roundest ear first. What a corner is worth changes only when a neighbour of it
/// goes, because an ear that holds a corner holds a reflex one, which is not the next to go.
class EarClipper {
 public:
  EarClipper(std::vector<Point2> points, const std::vector<std::uint8_t>& keep)
      : points_(std::move(points)),
        keep_(keep),
        n_(static_cast<std::uint32_t>(points_.size())),
        next_(n_),
        previous_(n_),
        turn_(n_, 0),
        mayBlock_(n_, 0) {
    for (std::uint32_t k = 0; k < n_; ++k) {
      next_[k] = k + 1 == n_ ? 0 : k + 1;
      previous_[k] = k == 0 ? n_ - 1 : k - 1;
    }
    for (std::uint32_t k = 0; k < n_; ++k) noteReflex(k);
    for (std::uint32_t k = 0; k < n_; ++k) ears_.push({quality(k), k, 0});
  }

  /// Triangles as local corner indices.
  std::vector<std::array<std::uint32_t, 3>> run() {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::uint32_t some = 0;
    for (std::uint32_t left = n_; left > 3; --left) {
      const std::uint32_t ear = takeBest(), before = previous_[ear], after = next_[ear];
      triangles.push_back({before, ear, after});
      next_[before] = after;
      previous_[after] = before;
      turn_[ear] = kGone;
      for (const std::uint32_t k : {before, after}) {
        noteReflex(k);
        ears_.push({quality(k), k, ++turn_[k]});
      }
      some = after;
    }
    while (previous_[some] < some) some = previous_[some];
    triangles.push_back({some, next_[some], previous_[some]});
    return triangles;
  }

 private:
  static constexpr std::uint32_t kGone = 0xffffffffu;

  struct Ear {
    double quality;
    std::uint32_t corner;
    std::uint32_t turn;  ///< how often the corner was judged before

    /// Of equals the one with the smaller index is better.
    bool operator<(const Ear& other) const {
      return quality != other.quality ? quality < other.quality : corner > other.corner;
    }
  };

  std::uint32_t takeBest() {
    while (ears_.top().turn != turn_[ears_.top().corner]) ears_.pop();
    const std::uint32_t corner = ears_.top().corner;
    ears_.pop();
    return corner;
  }

  void noteReflex(std::uint32_t k) {
    if (mayBlock_[k] || cross(points_[previous_[k]], points_[k], points_[next_[k]]) > 0) return;
    mayBlock_[k] = 1;
    blockers_.push_back(k);
  }

  /// In (0, 1] for a proper ear, larger is rounder; below 0 where the ear is reflex, flat or not
  /// empty.
  double quality(std::uint32_t k) const {
    const Point2 &a = points_[previous_[k]], &b = points_[k], &c = points_[next_[k]];
    const double edges = squaredDistance(a, b) + squaredDistance(b, c) + squaredDistance(c, a);
    double q = edges > 0 ? cross(a, b, c) * 2 * std::sqrt(3.0) / edges : 0;
    if (!(q > 0)) return q < 0 ? q - 2 : -2;
    if (!isEmpty(a, b, c)) q -= 2;
    if (keep_[k]) q -= 1;
    return q;
  }

  bool isEmpty(const Point2& a, const Point2& b, const Point2& c) const {
    for (const std::uint32_t k : blockers_) {
      const Point2& p = points_[k];
      if (turn_[k] == kGone || p == a || p == b || p == c) continue;
      if (cross(a, b, p) >= 0 && cross(b, c, p) >= 0 && cross(c, a, p) >= 0) return false;
    }
    return true;
  }

  std::vector<Point2> points_;
  const std::vector<std::uint8_t>& keep_;  ///< corners that should not become ears
  std::uint32_t n_;
  std::vector<std::uint32_t> next_, previous_;  ///< round what is left
  std::vector<std::uint32_t> turn_;             ///< of each corner's valid entry in ears_, or kGone
  std::vector<std::uint8_t> mayBlock_;
  std::vector<std::uint32_t> blockers_;  ///< reflex and flat corners, also those that were
  std::priority_queue<Ear> ears_;
};

/// Whether the two triangles that nearly every program makes of a quad, (0, 1, 2) and (0, 2, 3),
/// are fine: texcoords should suit them, too.
bool isFan(const std::vector<Point2>& quad, const std::vector<std::uint8_t>& keep) {
  if (keep[1] || keep[3]) return false;
  for (std::size_t k = 0; k < 4; ++k)
    if (!(cross(quad[k], quad[(k + 1) % 4], quad[(k + 2) % 4]) > 0)) return false;
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
    for (const auto& local : EarClipper(std::move(points), keep).run())
      appendTriangle(mesh, f, local, out);
  }
  return out;
}

}  // namespace abflat
