#include "mesh/corner_table.h"

#include <algorithm>

#include "base/stable_order.h"

namespace abflat {
namespace {

/// A half-edge seen from its smaller vertex.
struct EdgeEnd {
  InputVertex other;  ///< larger vertex
  SurfaceCorner h;
};

/// Half-edges that are not diagonals, grouped by their smaller vertex (counting sort).
struct EdgeBuckets {
  std::vector<std::uint32_t> offset;
  std::vector<EdgeEnd> ends;
};

EdgeBuckets bucketEdges(const Triangulation& t, std::size_t vertexCount) {
  EdgeBuckets b;
  b.offset.assign(vertexCount + 1, 0);
  const auto lower = [&](SurfaceCorner h) {
    return std::min(t.vertex[h], t.vertex[nextCorner(h)]);
  };
  for (const SurfaceCorner h : t.vertex.ids())
    if (!t.isDiagonal[h]) ++b.offset[lower(h) + 1];
  for (std::size_t v = 0; v < vertexCount; ++v) b.offset[v + 1] += b.offset[v];
  std::vector<std::uint32_t> fill(b.offset.begin(), b.offset.end() - 1);
  b.ends.resize(b.offset.back());
  for (const SurfaceCorner h : t.vertex.ids())
    if (!t.isDiagonal[h])
      b.ends[fill[lower(h)]++] = {std::max(t.vertex[h], t.vertex[nextCorner(h)]), h};
  return b;
}

void matchGroup(const Triangulation& t, const EdgeEnd* first, const EdgeEnd* last,
                CornerTable& table) {
  const auto count = static_cast<std::uint32_t>(last - first);
  if (count == 1) return;
  const SurfaceCorner h0 = first[0].h, h1 = first[1].h;
  if (count == 2 && t.vertex[h0] == t.vertex[nextCorner(h1)]) {
    table.twin[h0] = h1;
    table.twin[h1] = h0;
    return;
  }
  BadEdge bad;
  bad.v0 = t.vertex[h0];
  bad.v1 = t.vertex[nextCorner(h0)];
  bad.faceCount = count;
  bad.faces = {t.face[triangleOf(h0)], t.face[triangleOf(h1)]};
  (count == 2 ? table.misoriented : table.nonManifold).push_back(bad);
  if (count == 2) return;
  for (const EdgeEnd* end = first; end != last; ++end) table.nonManifoldCorners.push_back(end->h);
}

/// A diagonal's twin lies in the same face, whose triangles are consecutive.
void matchDiagonals(const Triangulation& t, CornerTable& table) {
  struct Diagonal {
    PolygonCorner low, high;
    SurfaceCorner h;
  };
  std::vector<Diagonal> ofFace;
  const std::size_t triangles = table.triangles().size();
  for (SurfaceTriangle f(0), end(0); f < triangles; f = end) {
    while (end < triangles && t.face[end] == t.face[f]) ++end;
    if (end == f + 1) continue;
    ofFace.clear();
    for (const SurfaceCorner h : IdRange(cornerOf(f, 0), cornerOf(end, 0))) {
      const PolygonCorner from = t.corner[h], to = t.corner[nextCorner(h)];
      if (t.isDiagonal[h]) ofFace.push_back({std::min(from, to), std::max(from, to), h});
    }
    sortStably(ofFace, [](const Diagonal& a, const Diagonal& b) {
      return a.low != b.low ? a.low < b.low : a.high < b.high;
    });
    for (std::size_t i = 0; i + 1 < ofFace.size(); i += 2) {
      table.twin[ofFace[i].h] = ofFace[i + 1].h;
      table.twin[ofFace[i + 1].h] = ofFace[i].h;
    }
  }
}

}  // namespace

CornerTable buildCornerTable(const Triangulation& triangulation, std::size_t vertexCount,
                             const Listener& listener) {
  CornerTable table;
  table.vertex = triangulation.vertex;
  table.twin.assign(table.vertex.size(), {});
  EdgeBuckets buckets = bucketEdges(triangulation, vertexCount);
  for (std::size_t v = 0; v < vertexCount && listener.beat(); ++v) {
    EdgeEnd* first = buckets.ends.data() + buckets.offset[v];
    EdgeEnd* const last = buckets.ends.data() + buckets.offset[v + 1];
    std::sort(first, last, [](const EdgeEnd& a, const EdgeEnd& b) {
      return a.other != b.other ? a.other < b.other : a.h < b.h;
    });
    while (first != last) {
      EdgeEnd* end = first;
      while (end != last && end->other == first->other) ++end;
      matchGroup(triangulation, first, end, table);
      first = end;
    }
  }
  matchDiagonals(triangulation, table);
  return table;
}

}  // namespace abflat
