#include "seam/pockets.h"

#include <algorithm>
#include <array>
#include <set>
#include <tuple>

#include "base/stable_order.h"
#include "seam/path_forest.h"

namespace abflat {
namespace {

/// Two edges between the same two vertices of a cut surface.
struct Pocket {
  SurfaceCorner a, b;
};

std::vector<Pocket> pocketsOf(const CutSurface& s, const std::vector<SurfaceCorner>& doubled) {
  struct Edge {
    OpenVertex low, high;
    SurfaceCorner half;
  };
  std::vector<Edge> edges;
  for (const SurfaceCorner h : doubled)
    if (!s.twin[h].exists() || h < s.twin[h])
      edges.push_back({std::min(s.tail(h), s.head(h)), std::max(s.tail(h), s.head(h)), h});
  sortStably(edges, [](const Edge& a, const Edge& b) {
    return std::tie(a.low, a.high, a.half) < std::tie(b.low, b.high, b.half);
  });
  std::vector<Pocket> out;
  for (std::size_t i = 1; i < edges.size(); ++i)
    if (edges[i - 1].low == edges[i].low && edges[i - 1].high == edges[i].high)
      out.push_back({edges[i - 1].half, edges[i].half});
  return out;
}

/// What is reached from one side of a pocket's edges without crossing them.
class Side {
 public:
  Side(const CutSurface& s, const Pocket& pocket, SurfaceCorner start)
      : s_(s), edges_{pocket.a, pocket.b, s.twin[pocket.a], s.twin[pocket.b]}, start_(start) {
    reach(triangleOf(start));
  }

  /// False if all has been reached.
  bool grow() {
    if (next_ == reached_.size()) return false;
    const SurfaceTriangle f = reached_[next_++];
    for (int k = 0; k < 3; ++k) {
      const SurfaceCorner h = cornerOf(f, k);
      if (std::find(edges_.begin(), edges_.end(), h) != edges_.end()) continue;
      if (s_.twin[h].exists())
        reach(triangleOf(s_.twin[h]));
      else
        isOutside_ = true;
    }
    return true;
  }
  /// Whether the chart's outline has been met.
  bool isOutside() const { return isOutside_; }
  SurfaceCorner start() const { return start_; }

 private:
  void reach(SurfaceTriangle f) {
    if (isReached_.insert(f).second) reached_.push_back(f);
  }

  const CutSurface& s_;
  const std::array<SurfaceCorner, 4> edges_;
  const SurfaceCorner start_;
  std::set<SurfaceTriangle> isReached_;
  std::vector<SurfaceTriangle> reached_;
  std::size_t next_ = 0;
  bool isOutside_ = false;
};

/// A half-edge of the pocket with the pocket on its left. Both sides grow in turn, so that this
/// takes no longer than the smaller one does.
SurfaceCorner insideOf(const CutSurface& s, const Pocket& pocket) {
  for (const SurfaceCorner h : {pocket.a, pocket.b})
    if (!s.twin[h].exists()) return h;
  Side left(s, pocket, pocket.a), right(s, pocket, s.twin[pocket.a]);
  for (;;) {
    if (!left.grow()) return (left.isOutside() ? right : left).start();
    if (!right.grow()) return (right.isOutside() ? left : right).start();
  }
}

}  // namespace

std::vector<SurfaceCorner> doubledEdges(const SeamMesh& mesh) {
  const auto low = [&](SurfaceCorner h) { return std::min(mesh.tail(h), mesh.head(h)); };
  const auto high = [&](SurfaceCorner h) { return std::max(mesh.tail(h), mesh.head(h)); };
  const auto isListed = [&](SurfaceCorner h) { return !mesh.twin[h].exists() || h < mesh.twin[h]; };
  IdVector<SurfaceVertex, std::uint32_t> begin(mesh.vertexCount() + 1, 0);
  for (const SurfaceCorner h : mesh.corners())
    if (isListed(h)) ++begin[SurfaceVertex(low(h) + 1)];
  for (const SurfaceVertex v : mesh.vertices()) begin[SurfaceVertex(v + 1)] += begin[v];
  std::vector<SurfaceCorner> edges(begin.back());
  IdVector<SurfaceVertex, std::uint32_t> next = begin;
  for (const SurfaceCorner h : mesh.corners())
    if (isListed(h)) edges[next[low(h)]++] = h;

  std::vector<SurfaceCorner> out;
  // Per vertex, the last edge that ended there.
  IdVector<SurfaceVertex, SurfaceCorner> last(mesh.vertexCount());
  const auto add = [&](SurfaceCorner h) {
    out.push_back(h);
    if (mesh.twin[h].exists()) out.push_back(mesh.twin[h]);
  };
  for (const SurfaceCorner h : edges) {
    const SurfaceCorner other = last[high(h)];
    if (other.exists() && low(other) == low(h)) {
      add(other);
      add(h);
    }
    last[high(h)] = h;
  }
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

void openPockets(const SeamMesh& mesh, const std::vector<SurfaceCorner>& doubled, Seams& seams,
                 const Listener& listener) {
  // Each round opens all pockets that are not within others.
  constexpr int kMostRounds = 20;
  for (int round = 0; round < kMostRounds && !doubled.empty(); ++round) {
    const CutSurface s = cutAlong(mesh, seams, listener);
    const std::vector<Pocket> pockets = pocketsOf(s, doubled);
    if (pockets.empty()) return;
    IdVector<CutChartId, std::uint8_t> isWanted(s.charts.size(), 0);
    for (const Pocket& pocket : pockets) isWanted[s.chartOf(pocket.a)] = 1;
    const PathForest forest = findPaths(mesh, s, {}, isWanted, listener);
    for (const Pocket& pocket : pockets)
      markPath(mesh, forest, s.tail(prevCorner(insideOf(s, pocket))), seams);
  }
}

}  // namespace abflat
