#include "chart/chart_order.h"

#include <algorithm>
#include <array>

#include "mesh/triangle_walk.h"

namespace abflat {
namespace {

/// The corner of least ranks, of which its triangle's other corners have the second and third say.
ChartCorner startOf(const DiskChart& chart) {
  ChartCorner out(0);
  if (chart.eliminationRank.empty()) return out;
  using Ranks = std::array<std::uint32_t, 3>;
  const auto rank = [&](ChartCorner c) { return chart.eliminationRank[chart.vertexOfCorner[c]]; };
  const auto ranks = [&](ChartCorner c) {
    return Ranks{rank(c), rank(nextCorner(c)), rank(prevCorner(c))};
  };
  Ranks least = ranks(out);
  for (const ChartCorner c : chart.surfaceCorners()) {
    const Ranks own = ranks(c);
    if (!(own < least)) continue;
    least = own;
    out = c;
  }
  return out;
}

/// The first corner of each triangle, in the order of the walk; those that fill holes come last.
std::vector<ChartCorner> walk(const DiskChart& chart) {
  IdVector<ChartTriangle, std::uint8_t> isSeen(chart.triangleCount(), 0);
  std::vector<ChartCorner> out;
  out.reserve(chart.triangleCount());
  walkTriangles(startOf(chart), chart.twin, isSeen, out);
  if (chart.fillingTriangles == 0) return out;
  const auto isOnSurface = [&](ChartCorner c) {
    return triangleOf(c) < chart.triangleCount() - chart.fillingTriangles;
  };
  std::vector<ChartCorner> parted;
  parted.reserve(out.size());
  for (const bool isAsked : {true, false})
    for (const ChartCorner c : out)
      if (isOnSurface(c) == isAsked) parted.push_back(c);
  return parted;
}

}  // namespace

DiskChart walkedThrough(const DiskChart& chart, IdVector<ChartVertex, ChartVertex>& former) {
  DiskChart out;
  out.fillingTriangles = chart.fillingTriangles;
  out.filledHoles = chart.filledHoles;
  IdVector<ChartCorner, ChartCorner> now(chart.twin.size());
  IdVector<ChartVertex, ChartVertex> vertex(chart.vertexCount());
  ChartCorner next(0);
  former.clear();
  for (const ChartCorner first : walk(chart))
    for (const ChartCorner c : {first, nextCorner(first), prevCorner(first)}) {
      now[c] = next;
      ++next;
      const ChartVertex v = chart.vertexOfCorner[c];
      if (!vertex[v].exists()) {
        vertex[v] = former.push_back(v);
        out.inputVertex.push_back(chart.inputVertex[v]);
        if (!chart.eliminationRank.empty()) out.eliminationRank.push_back(chart.eliminationRank[v]);
      }
      out.vertexOfCorner.push_back(vertex[v]);
    }
  out.twin.resize(chart.twin.size());
  for (const ChartCorner c : now.ids())
    if (chart.twin[c].exists()) out.twin[now[c]] = now[chart.twin[c]];
  for (const ChartCorner h : chart.boundary) out.boundary.push_back(now[h]);
  std::rotate(out.boundary.begin(), std::min_element(out.boundary.begin(), out.boundary.end()),
              out.boundary.end());
  return out;
}

}  // namespace abflat
