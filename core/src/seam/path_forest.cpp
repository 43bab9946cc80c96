#include "seam/path_forest.h"

#include <algorithm>
#include <limits>
#include <queue>

namespace abflat {
namespace {

struct Reached {
  double distance;
  OpenVertex vertex;
  bool operator<(const Reached& o) const {  // so that the top of the queue is the smallest
    return distance != o.distance ? distance > o.distance : vertex > o.vertex;
  }
};

/// Calls visit(half-edge, neighbour) for the edges at a vertex, counter-clockwise.
template <typename Visit>
void forEachNeighbour(const CutSurface& s, OpenVertex v, Visit visit) {
  const SurfaceCorner first = s.outgoing[v];
  SurfaceCorner h = first;
  do {
    visit(h, s.head(h));
    const SurfaceCorner p = prevCorner(h);
    if (!s.twin[p].exists()) visit(p, s.vertexOfCorner[p]);
    h = s.twin[p];
  } while (h.exists() && h != first);
}

}  // namespace

PathForest findPaths(const SeamMesh& mesh, const CutSurface& s,
                     const std::vector<OpenVertex>& extra,
                     const IdVector<CutChartId, std::uint8_t>& isWanted, const Listener& listener) {
  const std::size_t n = s.vertexCount();
  PathForest f;
  f.distance.assign(n, std::numeric_limits<double>::infinity());
  f.towards.resize(n);
  f.next.resize(n);
  f.source.resize(n);
  std::vector<Reached> heap;
  const auto start = [&](OpenVertex v) {
    f.distance[v] = 0;
    f.source[v] = v;
    heap.push_back({0, v});
  };
  for (const OpenVertex v : s.vertices())
    if (s.isBoundary[v] && (isWanted.empty() || isWanted[s.chartOf(v)])) start(v);
  for (const OpenVertex v : extra) start(v);
  std::priority_queue<Reached> queue(std::less<Reached>(), std::move(heap));
  while (!queue.empty()) {
    const Reached top = queue.top();
    queue.pop();
    const OpenVertex v = top.vertex;
    if (top.distance > f.distance[v]) continue;
    listener.beat();
    forEachNeighbour(s, v, [&](SurfaceCorner h, OpenVertex w) {
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

double markEdge(const SeamMesh& mesh, SurfaceCorner h, Seams& seams) {
  if (!mesh.twin[h].exists() || seams[h]) return 0;
  seams[h] = seams[mesh.twin[h]] = 1;
  return mesh.length[h];
}

double markPath(const SeamMesh& mesh, const PathForest& forest, OpenVertex vertex, Seams& seams) {
  double length = 0;
  for (OpenVertex v = vertex; forest.towards[v].exists(); v = forest.next[v])
    length += markEdge(mesh, forest.towards[v], seams);
  return length;
}

void markThrough(const CutPaths& paths, SurfaceCorner h, Seams& seams) {
  markEdge(paths.mesh, h, seams);
  for (const OpenVertex end : {paths.surface.tail(h), paths.surface.head(h)})
    markPath(paths.mesh, paths.forest, end, seams);
}

}  // namespace abflat
