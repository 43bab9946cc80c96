#include "seam/fair_paths.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

#include "base/few_bits.h"
#include "mesh/triangle_geometry.h"
#include "seam/stars.h"

namespace abflat {
namespace {

using Path = std::vector<SurfaceCorner>;

constexpr double kUnreached = std::numeric_limits<double>::infinity();

/// Relative to the root of the mesh's area. A path moves no farther than this, however long it is.
constexpr double kFarthest = 0.15;

/// Cost of turning from one half-edge to another, with the angle `side` on one side of the path.
double turnCost(const SeamMesh& m, SurfaceCorner from, SurfaceCorner to, double side) {
  constexpr double kTurning = 2;  // in mean lengths of the two edges, for a full turn
  const double all = m.angleSum[m.vertexOfCorner[to]];
  const double turn = all > 0 ? 2 * side / all - 1 : 0;
  return kTurning * turn * turn * (m.length[from] + m.length[to]) / 2;
}

struct PathEnd {
  double expected;  ///< of the whole path
  double passed;
  SurfaceCorner at;
  bool operator<(const PathEnd& o) const {  // so that the top of the queue is the smallest
    return expected != o.expected ? expected > o.expected : at > o.at;
  }
};

class Fairer {
 public:
  Fairer(const SeamMesh& mesh, const IdVector<SurfaceCorner, double>& cost,
         IdVector<SurfaceCorner, float> width, Seams& seams, const Listener& listener)
      : mesh_(mesh),
        cost_(cost),
        width_(std::move(width)),
        farthest_(kFarthest * std::sqrt(mesh.totalArea())),
        seams_(seams),
        listener_(listener),
        stars_(mesh),
        isFixed_(mesh.twin.size(), 0),
        isGoal_(mesh.twin.size(), 0),
        isOpen_(mesh.vertexCount(), 0),
        isFilled_(mesh.vertexCount(), 0),
        hasFixed_(mesh.vertexCount(), 0),
        isNear_(mesh.vertexCount(), 0),
        settledAt_(mesh.twin.size(), 0),
        changedAt_(mesh.vertexCount(), 0),
        count_(mesh.vertexCount(), 0),
        passed_(mesh.vertexCount(), kUnreached),
        before_(mesh.twin.size()) {
    for (const SurfaceCorner h : mesh.corners()) {
      if (!mesh.twin[h].exists()) isOpen_[tail(h)] = isOpen_[head(h)] = 1;
      if (mesh.isFilling(triangleOf(h))) isFilled_[tail(h)] = 1;
      if (!seams[h] || !mesh.twin[h].exists()) continue;
      ++count_[tail(h)];
      if (!(width_[h] > 0) || !mesh.isOnSurface(h)) isFixed_[h] = hasFixed_[tail(h)] = 1;
    }
  }

  bool run() {
    constexpr int kPasses = 3;
    bool isAny = false, isChanged = true;
    for (int pass = 0; isChanged && pass < kPasses && listener_.beat(); ++pass) {
      isChanged = false;
      for (const Path& path : paths())
        if (isThere(path) && !isSettled(path)) isChanged = fair(path) || isChanged;
      isAny = isAny || isChanged;
    }
    return isAny;
  }

 private:
  SurfaceVertex tail(SurfaceCorner h) const { return mesh_.tail(h); }
  SurfaceVertex head(SurfaceCorner h) const { return mesh_.head(h); }
  bool isBarrier(SurfaceCorner h) const { return seams_[h] || !mesh_.twin[h].exists(); }
  bool isOutline(SurfaceVertex v) const { return count_[v] > 0 || isOpen_[v]; }
  bool isBlocked(SurfaceVertex v) const { return isOutline(v) || isFilled_[v]; }
  bool isEnd(SurfaceVertex v) const { return count_[v] == 1 && !isOpen_[v]; }
  bool isJunction(SurfaceVertex v) const {
    return count_[v] != 2 || isOpen_[v] || isFilled_[v] || hasFixed_[v];
  }

  template <typename Visit>
  void forEachOutgoing(SurfaceVertex v, Visit visit) const {
    stars_.forEach(v, visit);
  }

  Path reversed(const Path& path) const {
    Path out;
    for (std::size_t i = path.size(); i-- > 0;) out.push_back(mesh_.twin[path[i]]);
    return out;
  }

  /// Paths from junction to junction. A path that ends where it begins is listed as two halves.
  std::vector<Path> paths() const {
    std::vector<Path> out;
    IdVector<SurfaceCorner, std::uint8_t> isSeen(seams_.size(), 0);
    for (const bool isFromJunction : {true, false})
      for (const SurfaceCorner h : seams_.ids()) {
        if (!seams_[h] || !mesh_.twin[h].exists() || isFixed_[h] || isSeen[h]) continue;
        if (isFromJunction && !isJunction(tail(h))) continue;
        Path path = pathFrom(h);
        for (const SurfaceCorner g : path) isSeen[g] = isSeen[mesh_.twin[g]] = 1;
        if (head(path.back()) == tail(h)) {
          const auto half = path.begin() + static_cast<std::ptrdiff_t>(path.size() / 2);
          out.emplace_back(path.begin(), half);
          path.erase(path.begin(), half);
        }
        out.push_back(std::move(path));
      }
    return out;
  }

  Path pathFrom(SurfaceCorner h) const {
    Path out{h};
    for (SurfaceVertex v = head(h); !isJunction(v) && v != tail(out.front()); v = head(h)) {
      const SurfaceCorner back = mesh_.twin[h];
      forEachOutgoing(v, [&](SurfaceCorner g) {
        if (seams_[g] && g != back) h = g;
      });
      out.push_back(h);
    }
    return out;
  }

  /// Whether the path is still as it was when paths were listed.
  bool isThere(const Path& path) const {
    for (std::size_t i = 0; i < path.size(); ++i)
      if (!seams_[path[i]] || (i > 0 && isJunction(tail(path[i])))) return false;
    return !path.empty();
  }

  /// Whether nothing has changed at its ends since no better path was found.
  bool isSettled(const Path& path) const {
    return std::all_of(path.begin(), path.end(), [&](SurfaceCorner h) {
      return settledAt_[h] > std::max(changedAt_[tail(h)], changedAt_[head(h)]);
    });
  }

  void mark(const Path& path, bool isSeam) {
    for (const SurfaceCorner h : path) {
      seams_[h] = seams_[mesh_.twin[h]] = isSeam;
      for (const SurfaceVertex v : {tail(h), head(h)}) count_[v] += isSeam ? 1 : -1;
    }
  }

  bool fair(const Path& path) {
    // An end within a chart stays in place, so the junction at the other end slides.
    Path now = isEnd(head(path.back())) ? reversed(path) : path;
    bool isChanged = redraw(now);
    if (!isEnd(tail(now.front()))) {
      now = reversed(now);
      isChanged = redraw(now) || isChanged;
    }
    ++clock_;
    if (!isChanged)
      for (const SurfaceCorner h : now) settledAt_[h] = settledAt_[mesh_.twin[h]] = clock_;
    else
      for (const Path* p : {&path, &std::as_const(now)})
        for (const SurfaceVertex v : {tail(p->front()), head(p->back())}) changedAt_[v] = clock_;
    return isChanged;
  }

  bool redraw(Path& path) {
    double length = 0;
    float width = width_[path.front()];
    for (const SurfaceCorner h : path) {
      length += mesh_.length[h];
      width = std::min(width, width_[h]);
    }
    const double most = std::min(width * length, farthest_);
    const std::vector<SurfaceVertex> near = verticesNear(path, most);
    mark(path, false);
    Path now = cheapest(path, most);
    for (const SurfaceVertex v : near) isNear_[v] = 0;
    const bool isBetter = !now.empty();
    if (isBetter) path = std::move(now);
    mark(path, true);
    for (const SurfaceCorner h : path) width_[h] = width_[mesh_.twin[h]] = width;
    return isBetter;
  }

  /// Vertices that can be reached without straying farther than `most` from the path vertex they
  /// are reached from.
  std::vector<SurfaceVertex> verticesNear(const Path& path, double most) {
    std::vector<SurfaceVertex> out, from;
    const auto add = [&](SurfaceVertex v, SurfaceVertex start) {
      if (isNear_[v]) return;
      isNear_[v] = 1;
      out.push_back(v);
      from.push_back(start);
    };
    for (const SurfaceCorner h : path) add(tail(h), tail(h));
    add(head(path.back()), head(path.back()));
    const auto distance = [&](SurfaceVertex a, SurfaceVertex b) {
      return inFewBits(norm(edgeVector(mesh_.positions, a, b)));
    };
    for (std::size_t i = 0; i < out.size(); ++i) {
      const SurfaceVertex start = from[i];
      constexpr double kRounding = 1 + 1e-9;
      const double longest = kRounding * (most + distance(start, out[i]));
      stars_.forEachNear(out[i], longest, [&](SurfaceCorner h) {
        const SurfaceVertex v = head(h);
        if (!isNear_[v] && distance(start, v) <= most) add(v, start);
      });
    }
    return out;
  }

  /// The sector of the open surface that an outgoing half-edge is in, named by the boundary
  /// half-edge on its clockwise side.
  SurfaceCorner sectorOf(SurfaceCorner h) const {
    while (!isBarrier(h)) h = rotateClockwise(mesh_.twin, h);
    return h;
  }

  /// The outgoing half-edges of a sector but for the one that names it.
  template <typename Visit>
  void forEachInSector(SurfaceCorner sector, Visit visit) const {
    SurfaceCorner h = rotateCounterClockwise(mesh_.twin, sector);
    for (; h.exists() && !isBarrier(h); h = rotateCounterClockwise(mesh_.twin, h)) visit(h);
  }

  SurfaceCorner along(SurfaceCorner h, bool isForward) const {
    const auto step = [&](SurfaceCorner g) { return isForward ? nextCorner(g) : prevCorner(g); };
    for (h = step(h); !isBarrier(h);) h = step(mesh_.twin[h]);
    return h;
  }

  /// Sectors that the open path may end in: its own, and those that its end can slide to.
  Path goalsOf(const Path& path, double most) const {
    const SurfaceVertex last = head(path.back());
    if (!isOutline(last)) return {};
    Path out{sectorOf(mesh_.twin[path.back()])};
    if (count_[last] < 2 && !isOpen_[last]) return out;  // half of a loop
    for (const bool isForward : {true, false}) {
      double slid = 0;
      for (SurfaceCorner h = out.front(); slid < most;) {
        const SurfaceCorner next = along(h, isForward);
        slid += mesh_.length[isForward ? h : next];
        h = next;
        if (h == out.front() || tail(h) == tail(path.front())) break;
        if (slid < most) out.push_back(h);
      }
    }
    return out;
  }

  /// The cheapest path to replace one that has been opened; empty if it is no better. Each vertex
  /// only knows the cheapest way to reach it, which need not be the one that turns least
  /// afterwards.
  Path cheapest(const Path& path, double slide) {
    const double most = pathCost(mesh_, cost_, path);
    const SurfaceVertex first = tail(path.front()), last = head(path.back());
    const bool isFromWithin = !isOutline(first);
    const bool isAnywhere = isFromWithin && isOutline(last);
    const Path goals = isAnywhere ? Path{} : goalsOf(path, slide);
    const auto setGoals = [&](bool isGoal) {
      for (const SurfaceCorner sector : goals)
        forEachInSector(sector, [&](SurfaceCorner h) { isGoal_[h] = isGoal; });
    };
    setGoals(true);
    const auto isGoal = [&](SurfaceCorner h) {
      if (!isOutline(head(h))) return head(h) == last;
      return isAnywhere || isGoal_[mesh_.twin[h]];
    };
    const auto toGo = [&](SurfaceVertex v) {
      constexpr double kBelow = 1 - 1e-7;  // what rounding may add
      const double straight = inFewBits(kBelow * norm(edgeVector(mesh_.positions, v, last)));
      return isAnywhere ? 0 : std::max(0.0, kLeastCost * (straight - slide));
    };
    std::priority_queue<PathEnd> queue;
    std::vector<SurfaceVertex> reached;
    const auto reach = [&](SurfaceCorner h, double passed, SurfaceCorner before) {
      const SurfaceVertex v = head(h);
      if (!isNear_[v] || !mesh_.twin[h].exists()) return;
      // On an outline, the side from which a vertex is reached matters.
      if (!(passed < passed_[v]) && !isBlocked(v)) return;
      const double expected = passed + toGo(v);
      if (!(expected < most)) return;
      passed_[v] = passed;
      before_[h] = before;
      reached.push_back(v);
      queue.push({expected, passed, h});
    };
    const auto begin = [&](SurfaceCorner h) { reach(h, cost_[h], SurfaceCorner()); };
    if (isFromWithin)
      forEachOutgoing(first, begin);
    else
      forEachInSector(sectorOf(path.front()), begin);
    Path out;
    while (!queue.empty() && out.empty()) {
      const PathEnd top = queue.top();
      queue.pop();
      listener_.beat();
      const SurfaceVertex v = head(top.at);
      if (v == first) continue;
      if (isBlocked(v) || v == last) {
        if (!isGoal(top.at)) continue;
        for (SurfaceCorner h = top.at; h.exists(); h = before_[h]) out.push_back(h);
      } else if (top.passed <= passed_[v]) {
        double side = 0;
        const SurfaceCorner back = mesh_.twin[top.at];
        for (SurfaceCorner h = rotateClockwise(mesh_.twin, back); h != back;
             h = rotateClockwise(mesh_.twin, h)) {
          side += mesh_.angle[h];
          reach(h, top.passed + cost_[h] + turnCost(mesh_, top.at, h, side), top.at);
        }
      }
    }
    for (const SurfaceVertex v : reached) passed_[v] = kUnreached;
    setGoals(false);
    std::reverse(out.begin(), out.end());
    constexpr double kGain = 1e-6;  // more than rounding
    return pathCost(mesh_, cost_, out) < (1 - kGain) * most ? out : Path{};
  }

  const SeamMesh& mesh_;
  const IdVector<SurfaceCorner, double>& cost_;
  IdVector<SurfaceCorner, float> width_;
  const double farthest_;
  Seams& seams_;
  const Listener& listener_;
  const Stars stars_;
  IdVector<SurfaceCorner, std::uint8_t> isFixed_;
  IdVector<SurfaceCorner, std::uint8_t> isGoal_;  ///< leaves where the open path may end
  /// On the mesh's boundary, on a filled hole, on a seam that stays, near the path.
  IdVector<SurfaceVertex, std::uint8_t> isOpen_, isFilled_, hasFixed_, isNear_;
  /// When a path was last found to be the best, and when an end of a path last changed.
  IdVector<SurfaceCorner, std::uint32_t> settledAt_;
  IdVector<SurfaceVertex, std::uint32_t> changedAt_;
  std::uint32_t clock_ = 0;
  IdVector<SurfaceVertex, int> count_;             ///< number of seams at the vertex
  IdVector<SurfaceVertex, double> passed_;         ///< cost of the way to the vertex
  IdVector<SurfaceCorner, SurfaceCorner> before_;  ///< the half-edge leading to it
};

}  // namespace

double pathCost(const SeamMesh& mesh, const IdVector<SurfaceCorner, double>& cost,
                const std::vector<SurfaceCorner>& path) {
  double sum = 0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    sum += cost[path[i]];
    if (i == 0) continue;
    double side = 0;
    for (SurfaceCorner h = mesh.twin[path[i - 1]]; h != path[i];) {
      h = rotateClockwise(mesh.twin, h);
      side += mesh.angle[h];
    }
    sum += turnCost(mesh, path[i - 1], path[i], side);
  }
  return sum;
}

bool fairPaths(const SeamMesh& mesh, const IdVector<SurfaceCorner, double>& cost,
               IdVector<SurfaceCorner, float> width, Seams& seams, const Listener& listener) {
  return Fairer(mesh, cost, std::move(width), seams, listener).run();
}

}  // namespace abflat
