#include "draw/layout_outline.h"

#include <algorithm>

namespace abflat {
namespace {

/// A half-edge with the vertex opposite, sorted by its vertices without direction.
struct HalfEdge {
  std::uint32_t from, to, opposite;

  std::array<std::uint32_t, 3> key() const {
    return {std::min(from, to), std::max(from, to), from};
  }
  bool isTwinOf(const HalfEdge& other) const { return from == other.to && to == other.from; }
};

std::vector<HalfEdge> sortedHalfEdges(const std::vector<std::uint32_t>& triangles) {
  std::vector<HalfEdge> out;
  out.reserve(triangles.size());
  for (std::size_t f = 0; f + 2 < triangles.size(); f += 3)
    for (std::size_t k = 0; k < 3; ++k)
      out.push_back({triangles[f + k], triangles[f + (k + 1) % 3], triangles[f + (k + 2) % 3]});
  std::sort(out.begin(), out.end(),
            [](const HalfEdge& a, const HalfEdge& b) { return a.key() < b.key(); });
  return out;
}

}  // namespace

LayoutOutline outlineOf(const FlattenResult& flat) {
  constexpr std::uint32_t kNoVertex = 0xffffffffu;
  const std::vector<HalfEdge> edges = sortedHalfEdges(flat.triangles);
  LayoutOutline out;
  std::vector<std::uint32_t> next(flat.uv.size() / 2, kNoVertex);
  std::uint32_t start = kNoVertex;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const HalfEdge& e = edges[i];
    if (i + 1 < edges.size() && e.isTwinOf(edges[i + 1])) {
      out.inner.push_back({e.from, e.to, e.opposite, edges[i + 1].opposite});
      ++i;
      continue;
    }
    next[e.from] = e.to;
    start = std::min(start, e.from);
  }
  // Output vertices are one per fan of triangles, so that each lies on the loop at most once.
  for (std::uint32_t v = start; v != kNoVertex; v = next[v] == start ? kNoVertex : next[v])
    out.boundary.push_back(v);
  return out;
}

std::vector<std::vector<std::uint32_t>> trails(
    const std::vector<std::array<std::uint32_t, 4>>& edges, std::size_t vertexCount) {
  std::vector<std::uint32_t> offset(vertexCount + 1, 0);
  for (const auto& e : edges)
    for (const std::uint32_t v : {e[0], e[1]}) ++offset[v + 1];
  for (std::size_t v = 0; v < vertexCount; ++v) offset[v + 1] += offset[v];
  std::vector<std::uint32_t> around(2 * edges.size()), filled(offset.begin(), offset.end() - 1);
  for (std::uint32_t i = 0; i < edges.size(); ++i)
    for (const std::uint32_t v : {edges[i][0], edges[i][1]}) around[filled[v]++] = i;
  std::vector<std::uint8_t> isUsed(edges.size(), 0);
  std::vector<std::uint32_t> cursor(offset.begin(), offset.end() - 1);
  const auto unusedEdge = [&](std::uint32_t v) {
    while (cursor[v] < offset[v + 1] && isUsed[around[cursor[v]]]) ++cursor[v];
    return cursor[v] < offset[v + 1];
  };
  std::vector<std::vector<std::uint32_t>> out;
  for (std::uint32_t first = 0; first < vertexCount; ++first) {
    while (unusedEdge(first)) {
      std::vector<std::uint32_t> trail = {first};
      for (std::uint32_t v = first; unusedEdge(v); trail.push_back(v)) {
        const std::uint32_t i = around[cursor[v]];
        isUsed[i] = 1;
        v = edges[i][0] == v ? edges[i][1] : edges[i][0];
      }
      out.push_back(std::move(trail));
    }
  }
  return out;
}

}  // namespace abflat
