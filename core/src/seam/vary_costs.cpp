#include "seam/vary_costs.h"

#include "base/few_bits.h"
#include "cut/mesh_parts.h"
#include "mesh/triangle_geometry.h"
#include "seam/principal_axes.h"

namespace abflat {
namespace {

void makeFrontDearer(double most, SeamMesh& mesh) {
  for (const SurfaceCorner h : mesh.dearness.ids()) {
    const double share = (mesh.dearness[h] - 1) / (kDearInFront - 1);
    const double factor = inFewBits(1 + (most - 1) * share);
    mesh.cost[h] *= factor;
    mesh.dearness[h] *= factor;
  }
}

}  // namespace

void varyCosts(int variant, SeamMesh& mesh) {
  if (variant == 0) return;
  constexpr double kSeveralTimes = 5, kLastResort = 1e4;
  const double inFront = variant % 2 == 1 ? kSeveralTimes : kLastResort;
  if (isForFront(variant) || !mesh.front.empty()) makeFrontDearer(inFront, mesh);
  if (isForFront(variant)) return;
  constexpr int kAxes = 3;
  constexpr double kMost = 0.4, kMean = 1.0 / 3;  // of the square of a coordinate, on a sphere
  const Vec3 axis = principalAxes(mesh).axes[static_cast<std::size_t>((variant - 1) % kAxes)];
  const double weight = variant > kAxes ? -kMost : kMost;
  IdVector<SurfaceTriangle, double> factor;
  for (const Vec3& normal : triangleNormals(mesh)) {
    const double along = dot(axis, normal);
    factor.push_back(1 + weight * (along * along - kMean));
  }
  for (const SurfaceCorner h : mesh.corners()) {
    const SurfaceCorner o = mesh.twin[h];
    if (o.exists() && h < o)
      mesh.cost[h] = mesh.cost[o] =
          inFewBits(mesh.cost[h] * (factor[triangleOf(h)] + factor[triangleOf(o)]) / 2);
  }
}

}  // namespace abflat
