#include "cut/front.h"

#include <algorithm>
#include <cmath>

#include "base/constants.h"
#include "base/smooth_step.h"
#include "cut/mesh_parts.h"
#include "cut/normals_around.h"
#include "mesh/vec3_sum.h"

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

/// The way a front faces. Figures look ahead; in one that lies on its back, hollows open upwards,
/// and towards its feet as below its chin. In a bowl or a landscape they open upwards only.
Vec3 ahead(const Vec3& open, std::size_t upAxis) {
  constexpr double kLies = 1.3, kOnlyUp = 3;
  Vec3 level = open, up{};
  level[upAxis] = 0;
  up[upAxis] = open[upAxis];
  const double ratio = open[upAxis] / norm(level);
  return ratio > kLies && ratio < kOnlyUp ? up : level;
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
    addBends();
    for (Bends& b : ofComponent_) b.open = ahead(b.open, upAxis);
    if (std::none_of(ofComponent_.begin(), ofComponent_.end(), hasFront)) return {};
    const NormalsAround around(mesh_);
    IdVector<SurfaceCorner, double> out;
    for (const SurfaceCorner h : mesh_.corners()) {
      const SurfaceCorner o = mesh_.twin[h];
      if (!o.exists() || o < h) continue;
      const Bends& b = bendsAt(h);
      if (!hasFront(b)) continue;
      out.resize(mesh_.twin.size(), 0);
      constexpr double kBeside = 0.3, kAhead = 0.7;
      constexpr double kSteps = 1024;  // so that rounding hardly ever changes one
      const double share = smoothStep(kBeside, kAhead, dot(around.at(h), b.open) / norm(b.open));
      out[h] = out[o] = std::floor(kSteps * share + 0.5) / kSteps;
    }
    return out;
  }

 private:
  Bends& bendsAt(SurfaceCorner h) { return ofComponent_[component_[triangleOf(h)]]; }

  void addBends() {
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
      b.open = sum(b.open, facing(h), turn);
    }
  }

  /// The mean direction of the two triangles of an edge.
  Vec3 facing(SurfaceCorner h) const {
    return unit(sum(normal_[triangleOf(h)], normal_[triangleOf(mesh_.twin[h])]));
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

IdVector<SurfaceTriangle, double> trianglesInFront(const SeamMesh& mesh) {
  if (mesh.dearness.empty()) return {};
  IdVector<SurfaceTriangle, double> out;
  for (const SurfaceTriangle f : mesh.triangles()) {
    double share = 0;
    for (const SurfaceCorner h : cornersOf(f))
      share += (mesh.dearnessAt(h) - 1) / (kDearInFront - 1) / 3;
    out.push_back(share);
  }
  return out;
}

}  // namespace abflat
