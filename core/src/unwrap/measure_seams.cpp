#include "unwrap/measure_seams.h"

#include <cmath>

#include "base/long_sum.h"
#include "mesh/triangle_geometry.h"

namespace abflat {

Seams visibleSeams(const OpenSurface& open) {
  Seams out = open.given;
  for (const SurfaceCorner h : out.ids())
    out[h] = out[h] || (open.seams[h] && open.mesh.isOnSurface(h));
  return out;
}

void measureSeams(const OpenSurface& open, const Seams& visible, SeamSummary& summary) {
  double length = 0;
  for (const SurfaceCorner h : visible.ids()) {
    if (!visible[h]) continue;
    length += open.mesh.length[h] / 2;
    ++summary.edges;
  }
  summary.edges /= 2;
  const double size = std::sqrt(open.mesh.totalArea());
  summary.relativeLength = size > 0 ? length / size : 0;
}

void measureSeams(const std::vector<double>& positions, const CornerTable& table,
                  const Seams& visible, SeamSummary& summary) {
  LongSum length, area;
  for (const SurfaceTriangle f : table.triangles()) {
    area.add(areaOf(positions, verticesOf(table.vertex, f)));
    for (const SurfaceCorner h : cornersOf(f)) {
      if (!visible[h]) continue;
      length.add(norm(edgeVector(positions, table.vertex[h], table.vertex[nextCorner(h)])) / 2);
      ++summary.edges;
    }
  }
  summary.edges /= 2;
  summary.relativeLength = area.value() > 0 ? length.value() / std::sqrt(area.value()) : 0;
}

double seamCost(const OpenSurface& open) {
  const double size = std::sqrt(open.mesh.totalArea());
  double sum = 0;
  const Seams visible = visibleSeams(open);
  for (const SurfaceCorner h : visible.ids())
    if (visible[h]) sum += open.mesh.cost[h] / 2;
  return size > 0 ? sum / size : 0;
}

double seamLength(const OpenSurface& open) {
  SeamSummary out;
  measureSeams(open, visibleSeams(open), out);
  return out.relativeLength;
}

}  // namespace abflat
