#include "seam/piece_cutter.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace abflat {
namespace {

double twiceArea(PlanePoint o, PlanePoint a, PlanePoint b) {
  return (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
}

/// Calls visit(half-edge) for those that leave a vertex, with the surface on their left.
template <typename Visit>
void forEachLeaving(const CutSurface& s, OpenVertex v, Visit visit) {
  const SurfaceCorner first = s.outgoing[v];
  SurfaceCorner h = first;
  do {
    visit(h);
    h = s.twin[prevCorner(h)];
  } while (h.exists() && h != first);
}

PieceId pieceOf(CutChartId chart) { return PieceId(std::uint32_t{chart}); }

bool contains(const std::vector<OpenVertex>& list, OpenVertex x) {
  return std::find(list.begin(), list.end(), x) != list.end();
}

/// The vertices from one point of a loop to another, both included.
IdVector<BoundaryIndex, OpenVertex> wayAlong(const IdVector<BoundaryIndex, OpenVertex>& loop,
                                             BoundaryIndex from, BoundaryIndex to) {
  IdVector<BoundaryIndex, OpenVertex> out;
  for (BoundaryIndex i = from; i != to; i = nextAlong(i, loop.size())) out.push_back(loop[i]);
  out.push_back(loop[to]);
  return out;
}

}  // namespace

PieceCutter::PieceCutter(const SeamMesh& mesh, const CutSurface& surface,
                         const IdVector<OpenVertex, PlanePoint>& at)
    : mesh_(mesh),
      surface_(surface),
      at_(at),
      pieces_(surface.charts.size()),
      isTaken_(surface.isBoundary),
      isCut_(mesh.twin.size(), 0) {
  for (const CutChartId c : surface.charts.ids())
    for (const SurfaceCorner h : surface.outline(c)) pieces_[pieceOf(c)].loop.push_back(beginOf(h));
  pieceOfTriangle_.reserve(mesh.triangleCount());
  for (const SurfaceTriangle f : mesh.triangles()) {
    const PieceId piece = pieceOf(surface.chartOfTriangle[f]);
    pieceOfTriangle_.push_back(piece);
    addTriangle(f, pieces_[piece]);
  }
}

double PieceCutter::distance(OpenVertex a, OpenVertex b) const {
  const double x = at_[a].x - at_[b].x, y = at_[a].y - at_[b].y;
  return std::sqrt(x * x + y * y);
}

/// The vertices near point i of the loop; that point comes first.
PieceCutter::Vertices PieceCutter::verticesNear(const Loop& loop, BoundaryIndex i,
                                                double reach) const {
  constexpr double kBarely = 1 - 1e-9;
  Vertices out{loop[i]};
  const std::size_t n = loop.size();
  for (const std::size_t step : {std::size_t{1}, n - 1})
    for (std::size_t k = (i + step) % n; k != i; k = (k + step) % n) {
      const OpenVertex v = loop[BoundaryIndex(k)];
      if (!(distance(v, loop[i]) < kBarely * reach)) break;
      out.push_back(v);
    }
  return out;
}

/// Whether a path may take the edge.
bool PieceCutter::isOpen(PieceId piece, SurfaceCorner h) const {
  return surface_.twin[h].exists() && !isCut_[h] && pieceOfTriangle_[triangleOf(h)] == piece &&
         mesh_.cost[h] < kBarredCost;
}

/// The cheapest path through the inside that stays near the straight line and is at most `room`
/// times as long; empty if there is none.
PieceCutter::Path PieceCutter::findPath(PieceId piece, const Vertices& from, const Vertices& to,
                                        double room) const {
  constexpr double kStraightness = 8, kSteps = 1048576;
  const OpenVertex a = from[0], b = to[0];
  const double straight = distance(a, b);
  IdVector<OpenVertex, double> reached(surface_.vertexCount(),
                                       std::numeric_limits<double>::infinity());
  IdVector<OpenVertex, SurfaceCorner> by(reached.size());
  using Entry = std::pair<double, OpenVertex>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  for (const OpenVertex v : from) {
    reached[v] = 0;
    queue.push({0, v});
  }
  Path out;
  while (!queue.empty()) {
    const auto [cost, v] = queue.top();
    queue.pop();
    if (cost > reached[v]) continue;
    if (contains(to, v)) {
      for (OpenVertex w = v; by[w].exists(); w = beginOf(out.back())) out.push_back(by[w]);
      std::reverse(out.begin(), out.end());
      return out;
    }
    forEachLeaving(surface_, v, [&, cost = cost](SurfaceCorner h) {
      const OpenVertex w = endOf(h);
      if (!isOpen(piece, h) || (isTaken_[w] && !contains(to, w)) ||
          distance(a, w) + distance(w, b) > room * straight)
        return;
      // Rounded, so that it is not the noise of the layout that decides.
      const double far = std::abs(twiceArea(at_[a], at_[b], at_[w])) / (straight * straight);
      const double off = std::round(far * kSteps) / kSteps;
      const double sum = cost + mesh_.cost[h] * (1 + kStraightness * off);
      if (!(sum < reached[w])) return;
      reached[w] = sum;
      by[w] = h;
      queue.push({sum, w});
    });
  }
  return out;
}

/// The hole that an edge passes through or along; none if there is no such hole.
HoleId PieceCutter::holeAt(SurfaceCorner h) const {
  for (const SurfaceCorner side : {h, mesh_.twin[h]})
    if (mesh_.isFilling(triangleOf(side))) return mesh_.hole[triangleOf(side)];
  return {};
}

/// For its length, where it can be seen.
double PieceCutter::costOf(const Path& path) const {
  double cost = 0, length = 0;
  for (const SurfaceCorner h : path) {
    if (!mesh_.isOnSurface(h)) continue;
    cost += mesh_.cost[h];
    length += mesh_.length[h];
  }
  return length > 0 ? cost / length : 0;
}

void PieceCutter::take(const Path& path) {
  for (const SurfaceCorner h : path) {
    if (mesh_.isOnSurface(h)) {
      length_ += mesh_.length[h];
      cost_ += std::min(mesh_.cost[h], mesh_.length[h]);
    }
    isCut_[h] = isCut_[surface_.twin[h]] = 1;
    cuts_.push_back(h);
    if (const HoleId hole = holeAt(h); hole.exists()) open(hole);
  }
}

/// From now on the filling of the hole connects nothing.
void PieceCutter::open(HoleId hole) {
  for (const SurfaceCorner h : mesh_.fillingCorners())
    if (mesh_.hole[triangleOf(h)] == hole && surface_.twin[h].exists())
      isCut_[h] = isCut_[surface_.twin[h]] = 1;
}

/// The next vertex along a hole's rim, counter-clockwise around the hole; none if the rim does not
/// pass `v`.
OpenVertex PieceCutter::nextAlongRim(HoleId hole, OpenVertex v) const {
  for (std::size_t i = mesh_.triangleCount(); i-- > 0;) {
    const SurfaceTriangle f(i);
    if (!mesh_.isFilling(f)) break;
    if (mesh_.hole[f] != hole) continue;
    for (const SurfaceCorner h : cornersOf(f))
      if (beginOf(h) == v && !mesh_.isFilling(triangleOf(mesh_.twin[h]))) return endOf(h);
  }
  return {};
}

/// Adds the vertices between two vertices of a hole's rim.
void PieceCutter::addRim(HoleId hole, OpenVertex from, OpenVertex to, Vertices& out) const {
  // Guards against following a rim for ever if it passes a vertex twice.
  const std::size_t most = out.size() + mesh_.triangleCount();
  for (OpenVertex v = nextAlongRim(hole, from); v.exists() && v != to && out.size() < most;
       v = nextAlongRim(hole, v))
    out.push_back(v);
}

/// The vertices between the ends of a path, seen from one side of it: where the path goes through
/// or along a hole, they follow the rim.
PieceCutter::Vertices PieceCutter::sideOf(const Path& path, bool isRight) const {
  Vertices out;
  for (std::size_t k = 0; k < path.size(); ++k) {
    const OpenVertex v = beginOf(path[k]);
    if (k > 0) out.push_back(v);
    const HoleId hole = holeAt(path[k]);
    if (!hole.exists()) continue;
    while (k + 1 < path.size() && holeAt(path[k + 1]) == hole) ++k;
    const OpenVertex w = endOf(path[k]);
    Vertices rim;
    addRim(hole, isRight ? v : w, isRight ? w : v, rim);
    if (!isRight) std::reverse(rim.begin(), rim.end());
    out.insert(out.end(), rim.begin(), rim.end());
  }
  return out;
}

void PieceCutter::addTriangle(SurfaceTriangle f, Piece& out) const {
  if (mesh_.isFilling(f)) return;
  out.area += mesh_.area[f];
  const auto corner = [&](std::size_t k) { return at_[surface_.tail(cornerOf(f, k))]; };
  out.flatArea += twiceArea(corner(0), corner(1), corner(2)) / 2;
}

/// Gives what lies on one side of the cuts a label of its own.
void PieceCutter::relabel(PieceId piece, SurfaceTriangle start, PieceId label, Piece& out) {
  std::vector<SurfaceTriangle> stack{start};
  pieceOfTriangle_[start] = label;
  while (!stack.empty()) {
    const SurfaceTriangle f = stack.back();
    stack.pop_back();
    addTriangle(f, out);
    for (const SurfaceCorner h : cornersOf(f)) {
      const SurfaceCorner o = surface_.twin[h];
      if (!o.exists() || isCut_[h] || pieceOfTriangle_[triangleOf(o)] != piece) continue;
      pieceOfTriangle_[triangleOf(o)] = label;
      stack.push_back(triangleOf(o));
    }
  }
}

bool PieceCutter::split(PieceId piece, BoundaryIndex from, BoundaryIndex to, double reach,
                        double mostCost) {
  constexpr double kNarrow = 1.2, kWide = 2;
  const Loop loop = pieces_[piece].loop;
  // Halving the distance keeps any vertex from being near both ends.
  const double near = std::min(reach, distance(loop[from], loop[to]) / 2);
  const Vertices begins = verticesNear(loop, from, near), ends = verticesNear(loop, to, near);
  Path path = findPath(piece, begins, ends, kNarrow);
  if (path.empty()) path = findPath(piece, begins, ends, kWide);
  const auto isSolid = [&](SurfaceCorner h) {
    return !mesh_.isFilling(triangleOf(surface_.twin[h]));
  };
  // A cut along a crease must not go on through a flat face.
  const auto isInFlat = [&](SurfaceCorner h) {
    return std::isfinite(mostCost) && mesh_.plainCost(h) > mesh_.length[h];
  };
  if (std::none_of(path.begin(), path.end(), isSolid) || costOf(path) > mostCost ||
      std::any_of(path.begin(), path.end(), isInFlat))
    return false;
  take(path);
  const auto indexOf = [&](OpenVertex v) {
    return BoundaryIndex(std::find(loop.begin(), loop.end(), v) - loop.begin());
  };
  const BoundaryIndex first = indexOf(beginOf(path.front())), last = indexOf(endOf(path.back()));
  Piece left, right;
  right.loop = wayAlong(loop, first, last);
  left.loop = wayAlong(loop, last, first);
  const Vertices onRight = sideOf(path, true), onLeft = sideOf(path, false);
  for (std::size_t i = onRight.size(); i-- > 0;) right.loop.push_back(onRight[i]);
  for (const OpenVertex v : onLeft) left.loop.push_back(v);
  for (const Vertices* side : {&onRight, &onLeft})
    for (const OpenVertex v : *side) isTaken_[v] = 1;
  const PieceId label(pieces_.size());
  const auto onSurface = std::find_if(path.begin(), path.end(), isSolid);
  relabel(piece, triangleOf(surface_.twin[*onSurface]), label, right);
  left.area = pieces_[piece].area - right.area;
  left.flatArea = pieces_[piece].flatArea - right.flatArea;
  pieces_[piece] = std::move(left);
  pieces_.push_back(std::move(right));
  return true;
}

}  // namespace abflat
