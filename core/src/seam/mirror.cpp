#include "seam/mirror.h"

#include <algorithm>
#include <cmath>

#include "mesh/triangle_geometry.h"
#include "seam/principal_axes.h"
#include "seam/seam_tips.h"

namespace abflat {
namespace {

/// In the unit cube. Models are mirrored exactly, but written with few digits.
constexpr double kTolerance = 1e-4;
/// Used while the plane is only roughly known.
constexpr double kCoarse = 1e-3;
/// Shares of the vertices and of the edges that must have an image. For edges it is less, since
/// diagonals of mirrored polygons need not be mirrored.
constexpr double kLeastMirrored = 0.9, kLeastMirroredEdges = 0.5;
/// How many vertices are sampled.
constexpr std::uint32_t kFew = 100, kMany = 1000;

Vec3 pointOf(const SeamMesh& mesh, SurfaceVertex v) {
  const double* p = &mesh.positions[3 * std::size_t{v}];
  return {p[0], p[1], p[2]};
}

struct Plane {
  Vec3 normal;
  double distance;

  double of(const Vec3& p) const { return dot(normal, p) - distance; }
  Vec3 image(Vec3 p) const {
    const double twice = 2 * of(p);
    for (std::size_t i = 0; i < 3; ++i) p[i] -= twice * normal[i];
    return p;
  }
};

/// Planes through the middle of the surface. A plane of symmetry is perpendicular to one of its
/// principal axes; the coordinate axes are tried as well, for surfaces whose principal axes are
/// ambiguous.
std::vector<Plane> candidates(const SeamMesh& mesh) {
  if (!(mesh.totalArea() > 0)) return {};
  const PrincipalAxes principal = principalAxes(mesh);
  std::vector<Plane> out;
  const auto add = [&](const Vec3& normal) {
    out.push_back({normal, dot(normal, principal.middle)});
  };
  for (const Vec3& normal : principal.axes) add(normal);
  for (const Vec3& normal : PrincipalAxes().axes) add(normal);
  return out;
}

/// Vertices sorted into cells, to find those near a point.
class VertexCells {
 public:
  explicit VertexCells(const SeamMesh& mesh) : mesh_(mesh) {
    entries_.reserve(mesh.vertexCount());
    for (const SurfaceVertex v : mesh.vertices())
      entries_.push_back({cellOf(pointOf(mesh, v), 0), v});
    std::sort(entries_.begin(), entries_.end());
  }

  SurfaceVertex nearest(const Vec3& at, double tolerance) const {
    SurfaceVertex best;
    double least = tolerance;
    const Cell low = cellOf(at, -tolerance), high = cellOf(at, tolerance);
    for (std::int32_t x = low[0]; x <= high[0]; ++x)
      for (std::int32_t y = low[1]; y <= high[1]; ++y) {
        const Entry first{{x, y, low[2]}, SurfaceVertex(0)};
        for (auto e = std::lower_bound(entries_.begin(), entries_.end(), first);
             e != entries_.end() && e->cell <= Cell{x, y, high[2]}; ++e) {
          const Vec3 p = pointOf(mesh_, e->vertex);
          const double distance = norm({p[0] - at[0], p[1] - at[1], p[2] - at[2]});
          if (!(distance < least)) continue;
          least = distance;
          best = e->vertex;
        }
      }
    return best;
  }

 private:
  using Cell = std::array<std::int32_t, 3>;
  struct Entry {
    Cell cell;
    SurfaceVertex vertex;
    bool operator<(const Entry& o) const {
      return cell != o.cell ? cell < o.cell : vertex < o.vertex;
    }
  };

  static Cell cellOf(const Vec3& at, double shift) {
    Cell out;
    for (std::size_t i = 0; i < 3; ++i)
      out[i] = static_cast<std::int32_t>(std::floor((at[i] + shift) / (4 * kTolerance)));
    return out;
  }

  const SeamMesh& mesh_;
  std::vector<Entry> entries_;
};

struct MirrorFit {
  Plane plane;
  double share;  ///< of the sampled vertices off the plane, those with an image
};

/// The plane that best mirrors every n-th vertex, among those that have an image.
MirrorFit fitTo(const SeamMesh& mesh, const VertexCells& cells, const Plane& plane,
                double tolerance, std::uint32_t sample) {
  const std::uint32_t stride = 1 + mesh.vertexCount() / sample;
  double all = 0, found = 0;
  Vec3 across{}, middle{};
  for (SurfaceVertex v(0); v < mesh.vertexCount(); v = SurfaceVertex(v + stride)) {
    const Vec3 p = pointOf(mesh, v);
    if (std::abs(plane.of(p)) <= tolerance) continue;
    ++all;
    const SurfaceVertex image = cells.nearest(plane.image(p), tolerance);
    if (!image.exists()) continue;
    ++found;
    const Vec3 q = pointOf(mesh, image);
    const double sign = plane.of(p) > 0 ? 1 : -1;
    for (std::size_t i = 0; i < 3; ++i) {
      across[i] += sign * (p[i] - q[i]);
      middle[i] += (p[i] + q[i]) / 2;
    }
  }
  if (!(found > 0)) return {plane, 0};
  const double length = norm(across);
  for (std::size_t i = 0; i < 3; ++i) {
    across[i] /= length;
    middle[i] /= found;
  }
  return {{across, dot(across, middle)}, found / all};
}

SurfaceCorner halfEdgeBetween(const SeamMesh& mesh,
                              const IdVector<SurfaceVertex, SurfaceCorner>& outgoing,
                              SurfaceVertex tail, SurfaceVertex head) {
  SurfaceCorner h = outgoing[tail];
  do {
    if (mesh.head(h) == head) return h;
    h = rotateCounterClockwise(mesh.twin, h);
  } while (h.exists() && h != outgoing[tail]);
  return {};
}

signed char sideOf(double distance) {
  if (std::abs(distance) <= kTolerance) return 0;
  return distance > 0 ? 1 : -1;
}

}  // namespace

Mirror findMirror(const SeamMesh& mesh, const Pulse& pulse) {
  const VertexCells cells(mesh);
  MirrorFit best{};
  for (const Plane& candidate : candidates(mesh)) {
    if (!pulse.beat(kFew)) return {};
    const MirrorFit fit = fitTo(mesh, cells, candidate, kCoarse, kFew);
    if (fit.share > best.share) best = fit;
  }
  if (best.share > 0) best = fitTo(mesh, cells, best.plane, kTolerance, kMany);
  if (best.share < kLeastMirrored) return {};
  const Plane& plane = best.plane;
  Mirror out;
  IdVector<SurfaceVertex, SurfaceVertex> image;
  for (const SurfaceVertex v : mesh.vertices()) {
    const Vec3 p = pointOf(mesh, v);
    const double distance = plane.of(p);
    out.side.push_back(sideOf(distance));
    image.push_back(out.side[v] == 0 ? v : cells.nearest(plane.image(p), kTolerance));
    pulse.beat();
  }
  const IdVector<SurfaceVertex, SurfaceCorner> outgoing = outgoingHalfEdges(mesh);
  std::size_t found = 0;
  for (const SurfaceCorner h : mesh.corners()) {
    const SurfaceVertex tail = image[mesh.tail(h)];
    const SurfaceVertex head = image[mesh.head(h)];
    const bool hasBoth = tail.exists() && head.exists();
    // The image of a boundary half-edge would be on its other side.
    out.image.push_back(hasBoth ? halfEdgeBetween(mesh, outgoing, tail, head) : SurfaceCorner());
    found += out.image[h].exists() || !mesh.twin[h].exists();
    pulse.beat();
  }
  const double edges = static_cast<double>(mesh.twin.size());
  if (static_cast<double>(found) < kLeastMirroredEdges * edges) return {};
  return out;
}

}  // namespace abflat
