#include "seam/occlusion.h"

#include <algorithm>
#include <cmath>

#include "base/constants.h"
#include "mesh/triangle_geometry.h"
#include "seam/principal_axes.h"

namespace abflat {
namespace {

/// Neighbouring triangles that face about the same way, treated as one.
struct Patch {
  Vec3 center{}, normal{};  ///< sums weighted by area, until settled
  double area = 0;
};
using PatchId = Id<struct PatchTag>;

Vec3 sum(const Vec3& a, const Vec3& b, double weight) {
  return {a[0] + weight * b[0], a[1] + weight * b[1], a[2] + weight * b[2]};
}

/// Cells along the principal axes, so that it does not matter how the mesh lies.
class PatchCells {
 public:
  PatchCells(const SeamMesh& mesh, std::uint32_t cells)
      : axes_(principalAxes(mesh)), cells_(cells) {
    Vec3 high{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
    for (std::size_t v = 0; v < mesh.vertexCount(); ++v) {
      const double* const p = &mesh.positions[3 * v];
      const Vec3 q = sum({p[0], p[1], p[2]}, axes_.middle, -1);
      for (std::size_t d = 0; d < 3; ++d) {
        const double x = dot(axes_.axes[d], q);
        low_[d] = std::min(low_[d], x);
        high[d] = std::max(high[d], x);
      }
    }
    for (std::size_t d = 0; d < 3; ++d) extent_ = std::max(extent_, high[d] - low_[d]);
  }

  std::size_t count() const { return std::size_t{8} * cells_ * cells_ * cells_; }

  /// The cell that a point is in, for surfaces that face about the same way.
  std::size_t of(const Vec3& center, const Vec3& normal) const {
    constexpr double kRounding = 1e-6;
    const Vec3 q = sum(center, axes_.middle, -1);
    std::size_t key = 0;
    for (std::size_t d = 0; d < 3; ++d) {
      const double at = extent_ > 0 ? (dot(axes_.axes[d], q) - low_[d]) / extent_ : 0;
      key = key * cells_ +
            std::min(static_cast<std::uint32_t>((at + kRounding) * cells_), cells_ - 1);
    }
    const double least = kRounding * norm(normal);
    for (std::size_t d = 0; d < 3; ++d) key = 2 * key + (dot(axes_.axes[d], normal) > least);
    return key;
  }

 private:
  PrincipalAxes axes_;
  std::uint32_t cells_;
  Vec3 low_{HUGE_VAL, HUGE_VAL, HUGE_VAL};
  double extent_ = 0;
};

}  // namespace

IdVector<SurfaceTriangle, double> occlusion(const SeamMesh& mesh, const Listener& listener) {
  // A surface passes through some fifteen times the square of that many patches; the work is the
  // square of their number.
  const double wanted = 0.7 * std::sqrt(std::sqrt(static_cast<double>(mesh.triangleCount())));
  const PatchCells cells(mesh, static_cast<std::uint32_t>(std::clamp(wanted, 2.0, 12.0)));
  std::vector<PatchId> patchAt(cells.count());
  IdVector<PatchId, Patch> patches;
  IdVector<SurfaceTriangle, PatchId> patchOf;
  for (const SurfaceTriangle f : mesh.triangles()) {
    const std::array<std::uint32_t, 3> v = verticesOf(mesh.vertexOfCorner, f);
    const Vec3 normal =
        cross(edgeVector(mesh.positions, v[0], v[1]), edgeVector(mesh.positions, v[0], v[2]));
    const Vec3 center = centreOf(mesh, f);
    const std::size_t key = cells.of(center, normal);
    if (!patchAt[key].exists()) patchAt[key] = patches.push_back({});
    Patch& p = patches[patchAt[key]];
    patchOf.push_back(patchAt[key]);
    p.center = sum(p.center, center, mesh.area[f]);
    p.normal = sum(p.normal, normal, 1);
    p.area += mesh.area[f];
    listener.beat();
  }
  for (Patch& p : patches) {
    const double size = norm(p.normal);
    for (std::size_t d = 0; d < 3; ++d) {
      p.center[d] = p.area > 0 ? p.center[d] / p.area : 0;
      p.normal[d] = size > 0 ? p.normal[d] / size : 0;
    }
  }
  IdVector<PatchId, double> hidden(patches.size(), 0);
  for (const PatchId i : patches.ids()) {
    const Patch& to = patches[i];
    double all = 0;
    for (const Patch& from : patches) {
      const Vec3 way = sum(from.center, to.center, -1);
      const double up = dot(to.normal, way), down = -dot(from.normal, way);
      if (!(up > 0 && down > 0)) continue;
      const double square = dot(way, way);
      all += from.area / (kPi * square + from.area) * (up * down / square);
    }
    hidden[i] = std::min(1.0, all);
    listener.beat(patches.size());
  }
  IdVector<SurfaceTriangle, double> out;
  out.reserve(patchOf.size());
  for (const PatchId p : patchOf) out.push_back(hidden[p]);
  return out;
}

}  // namespace abflat
