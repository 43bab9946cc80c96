#include "cut/edge_bends.h"

#include <algorithm>
#include <cmath>

#include "cut/mesh_parts.h"
#include "mesh/triangle_geometry.h"

namespace abflat {
namespace {

/// How far to look on either side, relative to the root of a component's area.
constexpr double kWidth = 0.015;
/// Bounds the work where triangles are tiny.
constexpr int kMostTriangles = 64;
/// An edge counts for at most this many times the angle between its triangles, so that those beside
/// a bevel do not count; and for a share of that angle if it is gone within the width.
constexpr double kTimesOwn = 2, kOfNarrow = 0.3;

/// For each triangle the root of its component's area.
IdVector<SurfaceTriangle, double> sizes(const SeamMesh& mesh) {
  const IdVector<SurfaceTriangle, SurfaceTriangle> component = componentsOf(mesh);
  IdVector<SurfaceTriangle, double> area(mesh.triangleCount(), 0), out;
  for (const SurfaceTriangle f : mesh.triangles()) area[component[f]] += mesh.area[f];
  for (const SurfaceTriangle f : mesh.triangles()) out.push_back(std::sqrt(area[component[f]]));
  return out;
}

bool isConcave(const SeamMesh& m, SurfaceCorner h) {
  const std::array<std::uint32_t, 3> v = verticesOf(m.vertexOfCorner, triangleOf(h));
  const Vec3 n = cross(edgeVector(m.positions, v[0], v[1]), edgeVector(m.positions, v[0], v[2]));
  const SurfaceCorner apex = prevCorner(m.twin[h]);
  return dot(edgeVector(m.positions, m.vertexOfCorner[h], m.vertexOfCorner[apex]), n) > 0;
}

void add(const Vec3& n, double times, Vec3& sum) {
  for (std::size_t d = 0; d < 3; ++d) sum[d] += times * n[d];
}

/// Whether an edge is flat, or smooth, whatever is beside its triangles.
bool isKnownBy(double own) {
  return kTimesOwn * own < kFlatBend ||
         (kOfNarrow * own > kFlatBend && kTimesOwn * own < kSmoothBend);
}

class Walker {
 public:
  explicit Walker(const SeamMesh& mesh) : mesh_(mesh), normal_(triangleNormals(mesh)) {}

  double bend(SurfaceCorner h, double width) const {
    const SurfaceCorner o = mesh_.twin[h];
    const double own = angleBetween(normal_[triangleOf(h)], normal_[triangleOf(o)]);
    if (isKnownBy(own)) return own;
    const double wide = angleBetween(beside(h, width), beside(o, width));
    return std::min(wide, kTimesOwn * own) + kOfNarrow * std::max(0.0, own - wide);
  }

 private:
  /// The mean direction of the surface on the left of a half-edge, from half the distance on. The
  /// way goes straight from the middle of the edge.
  Vec3 beside(SurfaceCorner h, double distance) const {
    Vec3 sum{};
    double passed = 0, at = 0.5;  // along the edge by which a triangle is entered
    Point along{0, 1};            // direction, relative to that edge
    for (int k = 0; k < kMostTriangles && passed < distance; ++k) {
      const Exit exit = through(h, at, along);
      const double before = std::max(passed, distance / 2);
      passed += exit.length;
      const double share = std::min(passed, distance) - before;
      if (share > 0) add(normal_[triangleOf(h)], share, sum);
      const SurfaceCorner next = mesh_.twin[exit.edge];
      if (!next.exists()) break;
      h = next;
      at = exit.at;
      along = exit.along;
    }
    return dot(sum, sum) > 0 ? sum : normal_[triangleOf(h)];
  }

  struct Point {
    double x = 0, y = 0;
  };
  struct Exit {
    SurfaceCorner edge;  ///< of the triangle that is left
    double length = 0;   ///< of the way through it
    double at = 0;       ///< along the edge's twin
    Point along;         ///< relative to the twin
  };

  /// The way from a point of an edge through the triangle beside it.
  Exit through(SurfaceCorner h, double at, Point along) const {
    const double base = mesh_.length[h], left = mesh_.length[prevCorner(h)],
                 right = mesh_.length[nextCorner(h)];
    if (!(base > 0)) return {nextCorner(h), 0, at, along};
    const Point apex{(base * base + left * left - right * right) / (2 * base),
                     2 * mesh_.area[triangleOf(h)] / base};
    const Point from{at * base, 0};
    const bool isRight = along.x * (apex.y - from.y) - along.y * (apex.x - from.x) > 0;
    const Point tail = isRight ? Point{base, 0} : apex, head = isRight ? apex : Point{0, 0};
    const Point edge{head.x - tail.x, head.y - tail.y};
    const double length = norm(edge.x, edge.y);
    Exit out;
    out.edge = isRight ? nextCorner(h) : prevCorner(h);
    if (!(length > 0)) return out;
    const Point unit{edge.x / length, edge.y / length};
    // Outwards is on the right of the edge.
    const double outwards = along.x * unit.y - along.y * unit.x;
    const double off = (tail.x - from.x) * unit.y - (tail.y - from.y) * unit.x;
    out.length = outwards > 0 ? std::max(0.0, off / outwards) : 0;
    const Point to{from.x + out.length * along.x, from.y + out.length * along.y};
    const double passed = ((to.x - tail.x) * unit.x + (to.y - tail.y) * unit.y) / length;
    out.at = 1 - std::clamp(passed, 0.0, 1.0);
    out.along = {-(along.x * unit.x + along.y * unit.y), outwards};
    return out;
  }

  const SeamMesh& mesh_;
  IdVector<SurfaceTriangle, Vec3> normal_;
};

}  // namespace

IdVector<SurfaceCorner, double> edgeBends(const SeamMesh& mesh, const Listener& listener) {
  const IdVector<SurfaceTriangle, double> size = sizes(mesh);
  const Walker walker(mesh);
  IdVector<SurfaceCorner, double> out(mesh.twin.size(), 0);
  for (const SurfaceCorner h : mesh.corners()) {
    const SurfaceCorner o = mesh.twin[h];
    if (!o.exists() || o < h) continue;
    const double bend = walker.bend(h, kWidth * size[triangleOf(h)]);
    out[h] = out[o] = isConcave(mesh, h) ? -bend : bend;
    listener.beat();
  }
  return out;
}

}  // namespace abflat
