#include "mesh/topology.h"

#include <algorithm>
#include <numeric>

namespace abflat {

Fans findFans(const CornerTable& table, std::size_t vertexCount) {
  const std::uint32_t n = static_cast<std::uint32_t>(table.vertex.size());
  Fans fans;
  fans.ofCorner.assign(n, kNone);
  for (std::uint32_t start = 0; start < n; ++start) {
    if (fans.ofCorner[start] != kNone) continue;
    const auto id = static_cast<std::uint32_t>(fans.inputVertex.size());
    fans.inputVertex.push_back(table.vertex[start]);
    std::uint32_t c = start;
    do {
      fans.ofCorner[c] = id;
      c = rotateCounterClockwise(table.twin, c);
    } while (c != kNone && c != start);
    if (c == start) continue;
    for (c = rotateClockwise(table.twin, start); c != kNone; c = rotateClockwise(table.twin, c))
      fans.ofCorner[c] = id;
  }
  // Counting sort by input vertex keeps the order of first corners within a vertex.
  std::vector<std::uint32_t> offset(vertexCount + 1, 0);
  for (std::uint32_t v : fans.inputVertex) ++offset[v + 1];
  std::partial_sum(offset.begin(), offset.end(), offset.begin());
  std::vector<std::uint32_t> renumbered(fans.inputVertex.size());
  for (std::size_t i = 0; i < renumbered.size(); ++i) renumbered[i] = offset[fans.inputVertex[i]]++;
  for (std::uint32_t& id : fans.ofCorner) id = renumbered[id];
  std::sort(fans.inputVertex.begin(), fans.inputVertex.end());
  return fans;
}

Components findComponents(const CornerTable& table) {
  const std::uint32_t triangles = table.triangleCount();
  Components out;
  out.ofTriangle.assign(triangles, kNone);
  std::vector<std::uint32_t> stack;
  for (std::uint32_t start = 0; start < triangles; ++start) {
    if (out.ofTriangle[start] != kNone) continue;
    const auto id = static_cast<std::uint32_t>(out.firstTriangle.size());
    out.firstTriangle.push_back(start);
    out.ofTriangle[start] = id;
    stack.push_back(start);
    while (!stack.empty()) {
      const std::uint32_t f = stack.back();
      stack.pop_back();
      for (std::uint32_t h = 3 * f; h < 3 * f + 3; ++h) {
        if (table.twin[h] == kNone) continue;
        const std::uint32_t g = table.twin[h] / 3;
        if (out.ofTriangle[g] != kNone) continue;
        out.ofTriangle[g] = id;
        stack.push_back(g);
      }
    }
  }
  return out;
}

std::vector<std::vector<std::uint32_t>> findBoundaryLoops(const CornerTable& table) {
  const std::uint32_t n = static_cast<std::uint32_t>(table.vertex.size());
  std::vector<std::uint8_t> seen(n, 0);
  std::vector<std::vector<std::uint32_t>> loops;
  for (std::uint32_t start = 0; start < n; ++start) {
    if (table.twin[start] != kNone || seen[start]) continue;
    loops.emplace_back();
    std::uint32_t h = start;
    do {
      seen[h] = 1;
      loops.back().push_back(h);
      h = nextCorner(h);
      while (table.twin[h] != kNone) h = nextCorner(table.twin[h]);
    } while (h != start);
  }
  return loops;
}

}  // namespace abflat
