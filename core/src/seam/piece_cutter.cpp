#include "seam/piece_cutter.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace abflat {
namespace {

double cross(PlanePoint o, PlanePoint a, PlanePoint b) {
  return (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
}

/// visit(half-edge) for those that leave a vertex, with the surface on their left.
template <typename Visit>
void forEachEdge(const CutSurface& s, std::uint32_t v, Visit visit) {
  const std::uint32_t first = s.outgoing[v];
  std::uint32_t h = first;
  do {
    visit(h);
    h = s.twin[prevCorner(h)];
  } while (h != kNone && h != first);
}

bool contains(const std::vector<std::uint32_t>& list, std::uint32_t x) {
  return std::find(list.begin(), list.end(), x) != list.end();
}

/// From one place of a loop to another, both included.
std::vector<std::uint32_t> wayAlong(const std::vector<std::uint32_t>& loop, std::size_t from,
                                    std::size_t to) {
  std::vector<std::uint32_t> out;
  for (std::size_t k = from; k != to; k = (k + 1) % loop.size()) out.push_back(loop[k]);
  out.push_back(loop[to]);
  return out;
}

}  // namespace

PieceCutter::PieceCutter(const SeamMesh& mesh, const CutSurface& surface,
                         const std::vector<PlanePoint>& at)
    : mesh_(mesh),
      surface_(surface),
      at_(at),
      pieces_(surface.charts.size()),
      pieceOfTriangle_(surface.chartOfTriangle),
      isTaken_(surface.isBoundary),
      isCut_(mesh.twin.size(), 0) {
  for (std::uint32_t c = 0; c < pieces_.size(); ++c)
    for (const std::uint32_t h : surface.outline(c)) pieces_[c].loop.push_back(beginOf(h));
  for (std::uint32_t f = 0; f < mesh.triangleCount(); ++f)
    addTriangle(f, pieces_[pieceOfTriangle_[f]]);
}

double PieceCutter::distance(std::uint32_t a, std::uint32_t b) const {
  const double x = at_[a].x - at_[b].x, y = at_[a].y - at_[b].y;
  return std::sqrt(x * x + y * y);
}

/// The one at a place comes first.
PieceCutter::Vertices PieceCutter::verticesNear(const Vertices& loop, std::size_t place,
                                                double reach) const {
  Vertices out{loop[place]};
  const std::size_t n = loop.size();
  for (const std::size_t step : {std::size_t{1}, n - 1})
    for (std::size_t k = (place + step) % n; k != place && distance(loop[k], loop[place]) < reach;
         k = (k + step) % n)
      out.push_back(loop[k]);
  return out;
}

/// Whether a path may take the edge.
bool PieceCutter::isOpen(std::uint32_t piece, std::uint32_t h) const {
  return surface_.twin[h] != kNone && !isCut_[h] && pieceOfTriangle_[h / 3] == piece &&
         mesh_.cost[h] < kBarredCost;
}

/// The cheapest path through the inside that leaves the straight one by little, of at most `room`
/// times its length; empty where there is none.
PieceCutter::Path PieceCutter::findPath(std::uint32_t piece, const Vertices& from,
                                        const Vertices& to, double room) const {
  constexpr double kStraightness = 8;
  const std::uint32_t a = from[0], b = to[0];
  const double straight = distance(a, b);
  std::vector<double> reached(surface_.vertexCount(), std::numeric_limits<double>::infinity());
  Path by(reached.size(), kNone);
  using Entry = std::pair<double, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  for (const std::uint32_t v : from) {
    reached[v] = 0;
    queue.push({0, v});
  }
  Path out;
  while (!queue.empty()) {
    const auto [cost, v] = queue.top();
    queue.pop();
    if (cost > reached[v]) continue;
    if (contains(to, v)) {
      for (std::uint32_t w = v; by[w] != kNone; w = beginOf(out.back())) out.push_back(by[w]);
      std::reverse(out.begin(), out.end());
      return out;
    }
    forEachEdge(surface_, v, [&, cost = cost](std::uint32_t h) {
      const std::uint32_t w = endOf(h);
      if (!isOpen(piece, h) || (isTaken_[w] && !contains(to, w)) ||
          distance(a, w) + distance(w, b) > room * straight)
        return;
      const double off = std::abs(cross(at_[a], at_[b], at_[w])) / (straight * straight);
      const double sum = cost + mesh_.cost[h] * (1 + kStraightness * off);
      if (!(sum < reached[w])) return;
      reached[w] = sum;
      by[w] = h;
      queue.push({sum, w});
    });
  }
  return out;
}

/// Which an edge leads through, or along; kNone where there is none.
std::uint32_t PieceCutter::holeAt(std::uint32_t h) const {
  if (mesh_.isFilling(h / 3)) return mesh_.hole[h / 3];
  return mesh_.isFilling(mesh_.twin[h] / 3) ? mesh_.hole[mesh_.twin[h] / 3] : kNone;
}

void PieceCutter::take(const Path& path) {
  for (const std::uint32_t h : path) {
    if (mesh_.isOnSurface(h)) length_ += mesh_.length[h];
    isCut_[h] = isCut_[surface_.twin[h]] = 1;
    cuts_.push_back(h);
    if (const std::uint32_t hole = holeAt(h); hole != kNone) open(hole);
  }
}

/// What fills the hole connects nothing any more.
void PieceCutter::open(std::uint32_t hole) {
  for (std::uint32_t f = mesh_.triangleCount(); f-- > 0 && mesh_.isFilling(f);)
    for (std::uint32_t h = 3 * f; mesh_.hole[f] == hole && h < 3 * f + 3; ++h)
      if (surface_.twin[h] != kNone) isCut_[h] = isCut_[surface_.twin[h]] = 1;
}

/// The vertices between two of a hole's rim, counter-clockwise round the hole.
void PieceCutter::addRim(std::uint32_t hole, std::uint32_t from, std::uint32_t to,
                         Vertices& out) const {
  const auto next = [&](std::uint32_t v) {
    for (std::uint32_t f = mesh_.triangleCount(); f-- > 0 && mesh_.isFilling(f);)
      for (std::uint32_t h = 3 * f; mesh_.hole[f] == hole && h < 3 * f + 3; ++h)
        if (beginOf(h) == v && !mesh_.isFilling(mesh_.twin[h] / 3)) return endOf(h);
    return to;
  };
  // A rim that passes a vertex twice is not followed for ever.
  const std::size_t most = out.size() + mesh_.triangleCount();
  for (std::uint32_t v = next(from); v != to && out.size() < most; v = next(v)) out.push_back(v);
}

/// What lies between the ends of a path on one side of it: where it leads through a hole or
/// along it, the rim.
PieceCutter::Vertices PieceCutter::sideOf(const Path& path, bool isRight) const {
  Vertices out;
  for (std::size_t k = 0; k < path.size(); ++k) {
    const std::uint32_t v = beginOf(path[k]);
    if (k > 0) out.push_back(v);
    const std::uint32_t hole = holeAt(path[k]);
    if (hole == kNone) continue;
    while (k + 1 < path.size() && holeAt(path[k + 1]) == hole) ++k;
    const std::uint32_t w = endOf(path[k]);
    Vertices rim;
    addRim(hole, isRight ? v : w, isRight ? w : v, rim);
    if (!isRight) std::reverse(rim.begin(), rim.end());
    out.insert(out.end(), rim.begin(), rim.end());
  }
  return out;
}

void PieceCutter::addTriangle(std::uint32_t f, Piece& out) const {
  if (mesh_.isFilling(f)) return;
  out.area += mesh_.area[f];
  out.flatArea += cross(at_[beginOf(3 * f)], at_[beginOf(3 * f + 1)], at_[beginOf(3 * f + 2)]) / 2;
}

/// What lies on one side of the cuts gets a label of its own.
void PieceCutter::relabel(std::uint32_t piece, std::uint32_t start, std::uint32_t label,
                          Piece& out) {
  std::vector<std::uint32_t> stack{start};
  pieceOfTriangle_[start] = label;
  while (!stack.empty()) {
    const std::uint32_t f = stack.back();
    stack.pop_back();
    addTriangle(f, out);
    for (std::uint32_t h = 3 * f; h < 3 * f + 3; ++h) {
      const std::uint32_t o = surface_.twin[h];
      if (o == kNone || isCut_[h] || pieceOfTriangle_[o / 3] != piece) continue;
      pieceOfTriangle_[o / 3] = label;
      stack.push_back(o / 3);
    }
  }
}

bool PieceCutter::split(std::uint32_t piece, std::size_t from, std::size_t to, double reach) {
  constexpr double kNarrow = 1.2, kWide = 2;
  const Vertices loop = pieces_[piece].loop;
  // No vertex is near both.
  const double near = std::min(reach, distance(loop[from], loop[to]) / 2);
  const Vertices begins = verticesNear(loop, from, near), ends = verticesNear(loop, to, near);
  Path path = findPath(piece, begins, ends, kNarrow);
  if (path.empty()) path = findPath(piece, begins, ends, kWide);
  const auto isSolid = [&](std::uint32_t h) { return !mesh_.isFilling(surface_.twin[h] / 3); };
  if (std::none_of(path.begin(), path.end(), isSolid)) return false;
  take(path);
  const auto placeOf = [&](std::uint32_t v) {
    return static_cast<std::size_t>(std::find(loop.begin(), loop.end(), v) - loop.begin());
  };
  const std::size_t first = placeOf(beginOf(path.front())), last = placeOf(endOf(path.back()));
  Piece left, right;
  right.loop = wayAlong(loop, first, last);
  left.loop = wayAlong(loop, last, first);
  const Vertices onRight = sideOf(path, true), onLeft = sideOf(path, false);
  right.loop.insert(right.loop.end(), onRight.rbegin(), onRight.rend());
  left.loop.insert(left.loop.end(), onLeft.begin(), onLeft.end());
  for (const Vertices* side : {&onRight, &onLeft})
    for (const std::uint32_t v : *side) isTaken_[v] = 1;
  const auto label = static_cast<std::uint32_t>(pieces_.size());
  const auto onSurface = std::find_if(path.begin(), path.end(), isSolid);
  relabel(piece, surface_.twin[*onSurface] / 3, label, right);
  left.area = pieces_[piece].area - right.area;
  left.flatArea = pieces_[piece].flatArea - right.flatArea;
  pieces_[piece] = std::move(left);
  pieces_.push_back(std::move(right));
  return true;
}

}  // namespace abflat
