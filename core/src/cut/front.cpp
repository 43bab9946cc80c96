#include "cut/front.h"

#include <cmath>

#include "base/constants.h"
#include "base/few_bits.h"
#include "base/smooth_step.h"
#include "cut/mesh_parts.h"
#include "mesh/triangle_geometry.h"

namespace abflat {
namespace {

/// A component's edges, each by its length times its bend.
struct Bends {
  double all = 0, sharp = 0, concave = 0;
  Vec3 open{};  ///< the directions that the concave ones face
  double area = 0;
};

/// Where parts are put together from flat faces, creases say where seams are hidden. Where hardly
/// anything is hollow, or it is everywhere alike, there is no front.
bool hasFront(const Bends& b) {
  constexpr double kMostSharp = 0.65, kLeastConcave = 0.18, kLeastOneWay = 0.1;
  const double ball = std::sqrt(16 * kPi);  // sum of a ball's bends, over the root of its area
  return b.all > ball * std::sqrt(b.area) && b.sharp < kMostSharp * b.all &&
         b.concave > kLeastConcave * b.all && norm(b.open) > kLeastOneWay * b.concave;
}

class FrontFinder {
 public:
  FrontFinder(const SeamMesh& mesh, const IdVector<SurfaceCorner, double>& bend)
      : mesh_(mesh),
        bend_(bend),
        component_(componentsOf(mesh)),
        normal_(triangleNormals(mesh)),
        ofComponent_(mesh.triangleCount()) {}

  IdVector<SurfaceCorner, double> find(std::size_t upAxis) {
    addBends(upAxis);
    IdVector<SurfaceCorner, double> out;
    for (const SurfaceCorner h : mesh_.corners()) {
      const SurfaceCorner o = mesh_.twin[h];
      if (!o.exists() || o < h) continue;
      const Bends& b = bendsAt(h);
      if (!hasFront(b)) continue;
      out.resize(mesh_.twin.size(), 0);
      constexpr double kBeside = 0.3, kAhead = 0.7;
      out[h] = out[o] =
          inFewBits(smoothStep(kBeside, kAhead, dot(facing(h), b.open) / norm(b.open)));
    }
    return out;
  }

 private:
  Bends& bendsAt(SurfaceCorner h) { return ofComponent_[component_[triangleOf(h)]]; }

  void addBends(std::size_t upAxis) {
    constexpr double kSharp = 35 * kPi / 180;
    for (const SurfaceCorner h : mesh_.corners()) {
      Bends& b = bendsAt(h);
      b.area += mesh_.area[triangleOf(h)] / 3;
      if (!mesh_.twin[h].exists() || mesh_.twin[h] < h) continue;
      const double turn = std::abs(bend_[h]) * mesh_.length[h];
      b.all += turn;
      if (std::abs(bend_[h]) > kSharp) b.sharp += turn;
      if (!(bend_[h] < 0)) continue;
      b.concave += turn;
      const Vec3 n = facing(h);
      for (std::size_t d = 0; d < 3; ++d)
        if (d != upAxis) b.open[d] += turn * n[d];
    }
  }

  /// The mean direction of the two triangles of an edge.
  Vec3 facing(SurfaceCorner h) const {
    const Vec3 &a = normal_[triangleOf(h)], &b = normal_[triangleOf(mesh_.twin[h])];
    const Vec3 sum{a[0] + b[0], a[1] + b[1], a[2] + b[2]};
    const double length = norm(sum);
    return length > 0 ? Vec3{sum[0] / length, sum[1] / length, sum[2] / length} : sum;
  }

  const SeamMesh& mesh_;
  const IdVector<SurfaceCorner, double>& bend_;
  IdVector<SurfaceTriangle, SurfaceTriangle> component_;
  IdVector<SurfaceTriangle, Vec3> normal_;
  IdVector<SurfaceTriangle, Bends> ofComponent_;  ///< at the least triangle of each
};

}  // namespace

IdVector<SurfaceCorner, double> findFront(const SeamMesh& mesh,
                                          const IdVector<SurfaceCorner, double>& bend,
                                          std::size_t upAxis) {
  return FrontFinder(mesh, bend).find(upAxis);
}

double shareInFront(const SeamMesh& mesh) {
  double all = 0, inFront = 0;
  for (const SurfaceTriangle f : mesh.triangles()) {
    all += mesh.area[f];
    for (const SurfaceCorner h : cornersOf(f))
      if (mesh.dearnessAt(h) > 1) inFront += mesh.area[f] / 3;
  }
  return all > 0 ? inFront / all : 0;
}

}  // namespace abflat
