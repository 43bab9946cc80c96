#include "mesh/topology.h"

#include <algorithm>
#include <numeric>

namespace abflat {

Fans findFans(const CornerTable& table, std::size_t vertexCount) {
  Fans fans;
  fans.ofCorner.assign(table.vertex.size(), {});
  for (const SurfaceCorner start : table.corners()) {
    if (fans.ofCorner[start].exists()) continue;
    const SurfaceVertex id = fans.inputVertex.push_back(table.vertex[start]);
    SurfaceCorner c = start;
    do {
      fans.ofCorner[c] = id;
      c = rotateCounterClockwise(table.twin, c);
    } while (c.exists() && c != start);
    if (c == start) continue;
    for (c = rotateClockwise(table.twin, start); c.exists(); c = rotateClockwise(table.twin, c))
      fans.ofCorner[c] = id;
  }
  // Counting sort by input vertex; keeps the order of first corners within a vertex.
  std::vector<std::uint32_t> offset(vertexCount + 1, 0);
  for (const InputVertex v : fans.inputVertex) ++offset[v + 1];
  std::partial_sum(offset.begin(), offset.end(), offset.begin());
  IdVector<SurfaceVertex, SurfaceVertex> renumbered(fans.inputVertex.size());
  for (const SurfaceVertex v : renumbered.ids())
    renumbered[v] = SurfaceVertex(offset[fans.inputVertex[v]]++);
  for (SurfaceVertex& id : fans.ofCorner) id = renumbered[id];
  std::sort(fans.inputVertex.begin(), fans.inputVertex.end());
  return fans;
}

Components findComponents(const CornerTable& table) {
  Components out;
  out.ofTriangle.assign(table.triangles().size(), {});
  std::vector<SurfaceTriangle> stack;
  for (const SurfaceTriangle start : table.triangles()) {
    if (out.ofTriangle[start].exists()) continue;
    const ComponentId id = out.firstTriangle.push_back(start);
    out.ofTriangle[start] = id;
    stack.push_back(start);
    while (!stack.empty()) {
      const SurfaceTriangle f = stack.back();
      stack.pop_back();
      for (const SurfaceCorner h : cornersOf(f)) {
        if (!table.twin[h].exists()) continue;
        const SurfaceTriangle g = triangleOf(table.twin[h]);
        if (out.ofTriangle[g].exists()) continue;
        out.ofTriangle[g] = id;
        stack.push_back(g);
      }
    }
  }
  return out;
}

std::vector<SurfaceLoop> findBoundaryLoops(const CornerTable& table) {
  IdVector<SurfaceCorner, std::uint8_t> seen(table.vertex.size(), 0);
  std::vector<SurfaceLoop> loops;
  for (const SurfaceCorner start : table.corners()) {
    if (table.twin[start].exists() || seen[start]) continue;
    loops.emplace_back();
    SurfaceCorner h = start;
    do {
      seen[h] = 1;
      loops.back().push_back(h);
      h = nextCorner(h);
      while (table.twin[h].exists()) h = nextCorner(table.twin[h]);
    } while (h != start);
  }
  return loops;
}

}  // namespace abflat
