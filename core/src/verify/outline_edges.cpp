#include "verify/outline_edges.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "base/stable_order.h"

namespace abflat {
namespace {

struct TriangleEdge {
  std::array<double, 4> ends;
  std::uint32_t triangle;
};

/// Of one island; each edge as often as its triangles have it.
std::vector<TriangleEdge> edgesOf(const IslandTriangles& islands, std::uint32_t island) {
  std::vector<TriangleEdge> out;
  for (std::uint32_t t = islands.begin[island]; t < islands.begin[island + 1]; ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const double* points = &islands.uv[6 * std::size_t{t}];
      const double *a = points + 2 * k, *b = points + 2 * ((k + 1) % 3);
      const bool isForward = std::array{a[0], a[1]} < std::array{b[0], b[1]};
      if (!isForward) std::swap(a, b);
      out.push_back({{a[0], a[1], b[0], b[1]}, t});
    }
  return out;
}

}  // namespace

OutlineEdges outlineEdges(const IslandTriangles& islands, const AtlasSize& size,
                          const std::vector<std::uint8_t>& isLeftOut) {
  OutlineEdges out;
  for (std::uint32_t i = 0; i < islands.islands(); ++i) {
    if (isLeftOut[i]) continue;
    std::vector<TriangleEdge> edges = edgesOf(islands, i);
    sortStably(edges, [](const TriangleEdge& a, const TriangleEdge& b) { return a.ends < b.ends; });
    for (std::size_t k = 0; k < edges.size();) {
      std::size_t next = k + 1;
      while (next < edges.size() && edges[next].ends == edges[k].ends) ++next;
      if (next == k + 1) {
        const std::array<double, 4>& e = edges[k].ends;
        out.ends.insert(out.ends.end(), {e[0] * size.width, e[1] * size.height, e[2] * size.width,
                                         e[3] * size.height});
        out.chart.push_back(i);
        out.triangle.push_back(edges[k].triangle);
      }
      k = next;
    }
  }
  return out;
}

}  // namespace abflat
