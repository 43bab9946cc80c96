#include "seam/path_forest.h"

#include <algorithm>
#include <limits>
#include <queue>

namespace abflat {
namespace {

struct Entry {
  double distance;
  std::uint32_t vertex;
  bool operator<(const Entry& o) const {  // the queue's top is the greatest
    return distance != o.distance ? distance > o.distance : vertex > o.vertex;
  }
};

/// visit(half-edge, neighbour) for the edges at a vertex, counter-clockwise.
template <typename Visit>
void forEachEdge(const CutSurface& s, std::uint32_t v, Visit visit) {
  const std::uint32_t first = s.outgoing[v];
  std::uint32_t h = first;
  do {
    visit(h, s.vertexOfCorner[nextCorner(h)]);
    const std::uint32_t p = prevCorner(h);
    if (s.twin[p] == kNone) visit(p, s.vertexOfCorner[p]);
    h = s.twin[p];
  } while (h != kNone && h != first);
}

}  // namespace

PathForest findPaths(const SeamMesh& mesh, const CutSurface& s,
                     const std::vector<std::uint32_t>& extra,
                     const std::vector<std::uint8_t>& isWanted, const Pulse& pulse) {
  const std::uint32_t n = s.vertexCount();
  PathForest f;
  f.distance.assign(n, std::numeric_limits<double>::infinity());
  f.towards.assign(n, kNone);
  f.next.assign(n, kNone);
  f.source.assign(n, kNone);
  std::vector<Entry> heap;
  const auto start = [&](std::uint32_t v) {
    f.distance[v] = 0;
    f.source[v] = v;
    heap.push_back({0, v});
  };
  for (std::uint32_t v = 0; v < n; ++v)
    if (s.isBoundary[v] && (isWanted.empty() || isWanted[s.chartOfVertex(v)])) start(v);
  for (const std::uint32_t v : extra) start(v);
  std::priority_queue<Entry> queue(std::less<Entry>(), std::move(heap));
  while (!queue.empty()) {
    const Entry top = queue.top();
    queue.pop();
    const std::uint32_t v = top.vertex;
    if (top.distance > f.distance[v]) continue;
    pulse.beat();
    forEachEdge(s, v, [&](std::uint32_t h, std::uint32_t w) {
      const double d = top.distance + mesh.cost[h];
      if (!(d < f.distance[w])) return;
      f.distance[w] = d;
      f.towards[w] = h;
      f.next[w] = v;
      f.source[w] = f.source[v];
      queue.push({d, w});
    });
  }
  return f;
}

double markEdge(const SeamMesh& mesh, std::uint32_t h, Seams& seams) {
  if (mesh.twin[h] == kNone || seams[h]) return 0;
  seams[h] = seams[mesh.twin[h]] = 1;
  return mesh.length[h];
}

double markPath(const SeamMesh& mesh, const PathForest& forest, std::uint32_t vertex,
                Seams& seams) {
  double length = 0;
  for (std::uint32_t v = vertex; forest.towards[v] != kNone; v = forest.next[v])
    length += markEdge(mesh, forest.towards[v], seams);
  return length;
}

}  // namespace abflat
