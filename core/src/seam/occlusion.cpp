#include "seam/occlusion.h"

#include <algorithm>
#include <cmath>

#include "base/constants.h"
#include "mesh/triangle_geometry.h"

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

}  // namespace

IdVector<SurfaceTriangle, double> occlusion(const SeamMesh& mesh, const Pulse& pulse) {
  // A surface passes through some fifteen times the square of that many patches; the work is the
  // square of their number.
  const double wanted = 0.7 * std::sqrt(std::sqrt(static_cast<double>(mesh.triangleCount())));
  const auto cells = static_cast<std::uint32_t>(std::clamp(wanted, 2.0, 12.0));
  std::vector<PatchId> patchAt(std::size_t{8} * cells * cells * cells);
  IdVector<PatchId, Patch> patches;
  IdVector<SurfaceTriangle, PatchId> patchOf;
  for (const SurfaceTriangle f : mesh.triangles()) {
    const std::array<std::uint32_t, 3> v = verticesOf(mesh.vertexOfCorner, f);
    const Vec3 normal =
        cross(edgeVector(mesh.positions, v[0], v[1]), edgeVector(mesh.positions, v[0], v[2]));
    Vec3 center{};
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t d = 0; d < 3; ++d)
        center[d] += mesh.positions[3 * std::size_t{v[k]} + d] / 3;
    std::size_t key = 0;
    for (std::size_t d = 0; d < 3; ++d) {
      const auto cell = static_cast<std::uint32_t>(center[d] * cells);
      key = key * cells + std::min(cell, cells - 1);
    }
    for (std::size_t d = 0; d < 3; ++d) key = 2 * key + (normal[d] > 0);
    if (!patchAt[key].exists()) patchAt[key] = patches.push_back({});
    Patch& p = patches[patchAt[key]];
    patchOf.push_back(patchAt[key]);
    p.center = sum(p.center, center, mesh.area[f]);
    p.normal = sum(p.normal, normal, 1);
    p.area += mesh.area[f];
    pulse.beat();
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
    pulse.beat(patches.size());
  }
  IdVector<SurfaceTriangle, double> out;
  out.reserve(patchOf.size());
  for (const PatchId p : patchOf) out.push_back(hidden[p]);
  return out;
}

}  // namespace abflat
