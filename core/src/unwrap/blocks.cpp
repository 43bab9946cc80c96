#include "unwrap/blocks.h"

#include <array>
#include <cmath>

#include "cut/mesh_parts.h"
#include "mesh/triangle_geometry.h"

namespace abflat {
namespace {

constexpr double kAskew = 0.01;  ///< radians; files round their coordinates

/// Three directions at right angles, taken from the normals that it is asked about.
class Cross {
 public:
  bool hasAlong(const Vec3& normal) {
    for (std::size_t k = 0; k < known_; ++k)
      if (std::abs(dot(normal, axes_[k])) > 1 - kAskew * kAskew / 2) return true;
    for (std::size_t k = 0; k < known_; ++k)
      if (std::abs(dot(normal, axes_[k])) > kAskew) return false;
    if (known_ == axes_.size()) return false;
    axes_[known_++] = normal;
    return true;
  }

 private:
  std::array<Vec3, 3> axes_{};
  std::size_t known_ = 0;
};

}  // namespace

IdVector<CutChartId, std::uint8_t> areBlocks(const SeamMesh& mesh, const CutSurface& parts) {
  constexpr double kRest = 1e-3;  // of the area: a knob, or slivers
  IdVector<CutChartId, std::uint8_t> out;
  const IdVector<SurfaceTriangle, Vec3> normals = triangleNormals(mesh);
  for (const CutChartId c : parts.charts.ids()) {
    const double most = kRest * parts.charts[c].area;
    Cross cross;
    double rest = 0;
    for (const SurfaceTriangle f : parts.trianglesOf(c)) {
      if (dot(normals[f], normals[f]) > 0 && !cross.hasAlong(normals[f])) rest += mesh.area[f];
      if (rest > most) break;
    }
    out.push_back(rest <= most);
  }
  return out;
}

}  // namespace abflat
