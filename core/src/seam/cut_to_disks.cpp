#include "seam/cut_to_disks.h"

#include "base/disjoint_sets.h"
#include "base/stable_order.h"
#include "seam/path_forest.h"

namespace abflat {
namespace {

struct NeededLoop {
  double cost;
  SurfaceCorner h;
};

/// Edges that are in neither the forest of paths nor a spanning tree of the triangles. Each closes
/// one loop that the topology requires to be cut (tree-cotree decomposition). The spanning tree
/// takes the edges of the costliest loops (Erickson and Whittlesey 2005).
std::vector<SurfaceCorner> neededEdges(const CutPaths& paths) {
  const CutSurface& s = paths.surface;
  std::vector<NeededLoop> loops;
  for (const SurfaceCorner h : s.corners()) {
    if (!s.twin[h].exists() || s.twin[h] < h) continue;
    if (s.charts[s.chartOf(h)].isDisk() || paths.forest.isTreeEdge(s, h)) continue;
    loops.push_back({paths.costThrough(h), h});
  }
  sortStably(loops, [](const NeededLoop& a, const NeededLoop& b) {
    return a.cost != b.cost ? a.cost > b.cost : a.h < b.h;
  });
  DisjointSets triangles(paths.mesh.triangles().size());
  std::vector<SurfaceCorner> needed;
  for (const NeededLoop& l : loops)
    if (!triangles.join(triangleOf(l.h), triangleOf(s.twin[l.h]))) needed.push_back(l.h);
  return needed;
}

/// A boundary with fewer than three edges cannot be drawn.
bool isAlmostClosed(const CutSurface& s, const CutSurface::Chart& chart) {
  return chart.isDisk() && s.loop(chart.firstLoop).size() < 3;
}

/// Opens a sphere along a path from its anchor, or from its existing opening, so that at least
/// three edges are open.
double openSphere(const CutPaths& paths, CutChartId chart, Seams& seams) {
  const CutSurface& s = paths.surface;
  const PathForest& forest = paths.forest;
  OpenVertex first, second;  // the two farthest vertices
  const auto isFarther = [&](OpenVertex v, OpenVertex than) {
    if (!than.exists()) return true;
    const bool isBarred = !(forest.distance[v] < kBarredCost);
    if (isBarred != !(forest.distance[than] < kBarredCost)) return !isBarred;
    return forest.distance[v] > forest.distance[than];
  };
  for (const SurfaceTriangle f : s.trianglesOf(chart))
    for (const SurfaceCorner c : cornersOf(f)) {
      const OpenVertex v = s.vertexOfCorner[c];
      if (v == first || v == second || !forest.towards[v].exists()) continue;
      if (isFarther(v, first)) {
        second = first;
        first = v;
      } else if (isFarther(v, second)) {
        second = v;
      }
    }
  if (!first.exists()) return 0;
  double length = markPath(paths.mesh, forest, first, seams);
  const bool isOneEdge = !forest.towards[forest.next[first]].exists();
  if (isOneEdge && s.charts[chart].loops == 0 && second.exists())
    length += markPath(paths.mesh, forest, second, seams);
  return length;
}

}  // namespace

TopologyCut cutToDisks(const SeamMesh& mesh, const CutSurface& s,
                       const IdVector<CutChartId, OpenVertex>& anchors, Seams& seams,
                       const Listener& listener) {
  TopologyCut cut;
  bool isAllDisks = true;
  std::vector<OpenVertex> roots;
  for (const CutChartId c : s.charts.ids()) {
    const CutSurface::Chart& chart = s.charts[c];
    isAllDisks = isAllDisks && chart.isDisk() && !isAlmostClosed(s, chart);
    if (chart.loops > 1) cut.joinedLoops += chart.loops - 1;
    if (chart.loops == 0)
      roots.push_back(anchors.empty() ? s.tail(cornerOf(chart.firstTriangle, 0)) : anchors[c]);
  }
  if (isAllDisks) return cut;
  const PathForest forest = findPaths(mesh, s, roots, {}, listener);
  const CutPaths paths{mesh, s, forest};
  for (const CutChartId c : s.charts.ids()) {
    const bool isSphere = s.charts[c].loops == 0 && s.charts[c].euler() == 2;
    if (!isSphere && !isAlmostClosed(s, s.charts[c])) continue;
    cut.length += openSphere(paths, c, seams);
    ++cut.openedSpheres;
  }
  const std::vector<SurfaceCorner> needed = neededEdges(paths);
  for (const SurfaceCorner h : needed) {
    cut.length += markEdge(mesh, h, seams);
    cut.length += markPath(mesh, forest, s.tail(h), seams);
    cut.length += markPath(mesh, forest, s.head(h), seams);
  }
  cut.handleLoops = static_cast<std::uint32_t>(needed.size()) - cut.joinedLoops;
  return cut;
}

}  // namespace abflat
