#include "seam/cut_to_disks.h"

#include <algorithm>
#include <numeric>

#include "seam/path_forest.h"

namespace abflat {
namespace {

/// Disjoint sets with path halving.
class Sets {
 public:
  explicit Sets(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0u); }
  bool join(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    if (a == b) return false;
    parent_[std::max(a, b)] = std::min(a, b);
    return true;
  }

 private:
  std::uint32_t find(std::uint32_t a) {
    while (parent_[a] != a) a = parent_[a] = parent_[parent_[a]];
    return a;
  }
  std::vector<std::uint32_t> parent_;
};

struct Loop {
  double cost;
  std::uint32_t h;
};

/// Edges that are in neither the forest of paths nor a spanning tree of the triangles: each closes
/// one loop that topology needs cut (tree-cotree decomposition). The dearest loops are left to the
/// spanning tree (Erickson and Whittlesey 2005).
std::vector<std::uint32_t> neededEdges(const SeamMesh& mesh, const CutSurface& s,
                                       const PathForest& forest) {
  std::vector<Loop> loops;
  for (std::uint32_t h = 0; h < s.twin.size(); ++h) {
    if (s.twin[h] == kNone || s.twin[h] < h) continue;
    if (s.charts[s.chartOfTriangle[h / 3]].isDisk() || forest.isTreeEdge(s, h)) continue;
    loops.push_back({forest.distance[s.vertexOfCorner[h]] + mesh.cost[h] +
                         forest.distance[s.vertexOfCorner[nextCorner(h)]],
                     h});
  }
  std::sort(loops.begin(), loops.end(), [](const Loop& a, const Loop& b) {
    return a.cost != b.cost ? a.cost > b.cost : a.h < b.h;
  });
  Sets triangles(mesh.triangleCount());
  std::vector<std::uint32_t> needed;
  for (const Loop& l : loops)
    if (!triangles.join(l.h / 3, s.twin[l.h] / 3)) needed.push_back(l.h);
  return needed;
}

/// A boundary of fewer edges cannot be drawn.
bool isAlmostClosed(const CutSurface& s, const CutSurface::Chart& chart) {
  return chart.isDisk() && s.loop(chart.firstLoop).size() < 3;
}

/// A sphere is opened along a path from its anchor, or from what is open of it, so that three edges
/// or more are open.
double openSphere(const SeamMesh& mesh, const CutSurface& s, const PathForest& forest,
                  std::uint32_t chart, Seams& seams) {
  std::uint32_t first = kNone, second = kNone;  // the farthest vertices
  const auto isFarther = [&](std::uint32_t v, std::uint32_t than) {
    if (than == kNone) return true;
    const bool isBarred = !(forest.distance[v] < kBarredCost);
    if (isBarred != !(forest.distance[than] < kBarredCost)) return !isBarred;
    return forest.distance[v] > forest.distance[than];
  };
  for (std::uint32_t i = s.triangleBegin[chart]; i < s.triangleBegin[chart + 1]; ++i)
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t v = s.vertexOfCorner[3 * s.triangleOrder[i] + k];
      if (v == first || v == second || forest.towards[v] == kNone) continue;
      if (isFarther(v, first)) {
        second = first;
        first = v;
      } else if (isFarther(v, second)) {
        second = v;
      }
    }
  if (first == kNone) return 0;
  double length = markPath(mesh, forest, first, seams);
  const bool isOneEdge = forest.towards[forest.next[first]] == kNone;
  if (isOneEdge && s.charts[chart].loops == 0 && second != kNone)
    length += markPath(mesh, forest, second, seams);
  return length;
}

}  // namespace

TopologyCut cutToDisks(const SeamMesh& mesh, const CutSurface& s,
                       std::vector<std::uint32_t> anchors, Seams& seams, const Pulse& pulse) {
  TopologyCut cut;
  bool isAllDisks = true;
  std::vector<std::uint32_t> roots;
  for (std::uint32_t c = 0; c < s.charts.size(); ++c) {
    const CutSurface::Chart& chart = s.charts[c];
    isAllDisks = isAllDisks && chart.isDisk() && !isAlmostClosed(s, chart);
    if (chart.loops > 1) cut.joinedLoops += chart.loops - 1;
    if (chart.loops == 0)
      roots.push_back(anchors.empty() ? s.vertexOfCorner[3 * chart.firstTriangle] : anchors[c]);
  }
  if (isAllDisks) return cut;
  const PathForest forest = findPaths(mesh, s, roots, {}, pulse);
  for (std::uint32_t c = 0; c < s.charts.size(); ++c) {
    const bool isSphere = s.charts[c].loops == 0 && s.charts[c].euler() == 2;
    if (!isSphere && !isAlmostClosed(s, s.charts[c])) continue;
    cut.length += openSphere(mesh, s, forest, c, seams);
    ++cut.openedSpheres;
  }
  const std::vector<std::uint32_t> needed = neededEdges(mesh, s, forest);
  for (const std::uint32_t h : needed) {
    cut.length += markEdge(mesh, h, seams);
    cut.length += markPath(mesh, forest, s.vertexOfCorner[h], seams);
    cut.length += markPath(mesh, forest, s.vertexOfCorner[nextCorner(h)], seams);
  }
  cut.handleLoops = static_cast<std::uint32_t>(needed.size()) - cut.joinedLoops;
  return cut;
}

}  // namespace abflat
