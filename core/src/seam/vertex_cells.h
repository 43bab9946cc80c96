#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "cut/surface_mesh.h"
#include "mesh/triangle_geometry.h"

namespace abflat {

inline Vec3 placeOf(const SeamMesh& mesh, SurfaceVertex v) {
  const double* p = &mesh.positions[3 * std::size_t{v}];
  return {p[0], p[1], p[2]};
}

/// Vertices sorted into cells, to find those near a point.
class VertexCells {
 public:
  /// Every `stride`-th vertex. Cells should be several times as large as distances looked for.
  VertexCells(const SeamMesh& mesh, double cell, std::uint32_t stride = 1)
      : mesh_(mesh), cell_(cell) {
    entries_.reserve(mesh.vertexCount() / stride + 1);
    for (SurfaceVertex v(0); v < mesh.vertexCount(); v = SurfaceVertex(v + stride))
      entries_.push_back({cellOf(placeOf(mesh, v), 0), v});
    std::sort(entries_.begin(), entries_.end());
  }

  /// None if there is no vertex within `tolerance`.
  SurfaceVertex nearest(const Vec3& at, double tolerance) const {
    SurfaceVertex best;
    double least = tolerance;
    const Cell low = cellOf(at, -tolerance), high = cellOf(at, tolerance);
    for (std::int32_t x = low[0]; x <= high[0]; ++x)
      for (std::int32_t y = low[1]; y <= high[1]; ++y) {
        const Entry first{{x, y, low[2]}, SurfaceVertex(0)};
        for (auto e = std::lower_bound(entries_.begin(), entries_.end(), first);
             e != entries_.end() && e->cell <= Cell{x, y, high[2]}; ++e) {
          const Vec3 p = placeOf(mesh_, e->vertex);
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

  Cell cellOf(const Vec3& at, double shift) const {
    Cell out;
    for (std::size_t i = 0; i < 3; ++i)
      out[i] = static_cast<std::int32_t>(std::floor((at[i] + shift) / cell_));
    return out;
  }

  const SeamMesh& mesh_;
  double cell_;
  std::vector<Entry> entries_;
};

}  // namespace abflat
