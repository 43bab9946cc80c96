#include "seam/mirror.h"

#include <optional>

#include "seam/mirror_plane.h"
#include "seam/seam_tips.h"

namespace abflat {
namespace {

/// Shares of the area and of the length of edges that must have an image. For edges it is less,
/// since diagonals of mirrored polygons need not be mirrored.
constexpr double kLeastMirroredArea = 0.7, kLeastMirroredEdges = 0.5;

using VertexImages = IdVector<SurfaceVertex, SurfaceVertex>;

/// A vertex on the plane is its own image.
VertexImages vertexImages(const SeamMesh& mesh, const VertexCells& cells, const MirrorPlane& plane,
                          const Listener& listener) {
  VertexImages nearest;
  nearest.reserve(mesh.vertexCount());
  for (const SurfaceVertex v : mesh.vertices()) {
    nearest.push_back(cells.nearest(plane.image(placeOf(mesh, v)), kMirrorTolerance));
    listener.beat();
  }
  VertexImages out(nearest.size());
  for (const SurfaceVertex v : mesh.vertices())
    if (nearest[v].exists() && nearest[nearest[v]] == v) out[v] = nearest[v];
  return out;
}

/// Finds edges between vertices.
class EdgeFinder {
 public:
  explicit EdgeFinder(const SeamMesh& mesh)
      : mesh_(mesh), outgoing_(outgoingHalfEdges(mesh)), degree_(mesh.vertexCount(), 0) {
    for (const SurfaceCorner h : mesh.corners()) ++degree_[mesh.tail(h)];
  }

  bool mayBeCut(SurfaceCorner h) const {
    return mesh_.twin[h].exists() && mesh_.cost[h] < kBarredCost;
  }

  /// None if the edge may not be cut.
  SurfaceCorner between(SurfaceVertex tail, SurfaceVertex head) const {
    const bool isForward = degree_[tail] <= degree_[head];
    SurfaceCorner out;
    forEachAround(isForward ? tail : head, [&](SurfaceCorner h) {
      if (mesh_.head(h) == (isForward ? head : tail) && mayBeCut(h)) out = h;
    });
    return isForward || !out.exists() ? out : mesh_.twin[out];
  }

  /// The cheaper way around an edge that has the two vertices on either side.
  std::array<SurfaceCorner, 2> around(SurfaceVertex tail, SurfaceVertex head) const {
    if (degree_[tail] > degree_[head]) {
      const std::array<SurfaceCorner, 2> back = around(head, tail);
      if (!back[0].exists()) return {};
      return {mesh_.twin[back[1]], mesh_.twin[back[0]]};
    }
    std::array<SurfaceCorner, 2> out;
    double least = kBarredCost;
    const auto consider = [&](SurfaceCorner first, SurfaceCorner second) {
      if (!first.exists() || !second.exists() || !mayBeCut(first) || !mayBeCut(second)) return;
      const double cost = mesh_.cost[first] + mesh_.cost[second];
      if (!(cost < least)) return;
      least = cost;
      out = {first, second};
    };
    forEachAround(tail, [&](SurfaceCorner h) {
      const SurfaceCorner o = mesh_.twin[nextCorner(h)];
      if (!o.exists() || mesh_.tail(prevCorner(o)) != head) return;
      consider(h, nextCorner(o));
      consider(mesh_.twin[prevCorner(h)], mesh_.twin[prevCorner(o)]);
    });
    return out;
  }

 private:
  template <typename Visit>
  void forEachAround(SurfaceVertex v, Visit visit) const {
    SurfaceCorner h = outgoing_[v];
    do {
      visit(h);
      h = rotateCounterClockwise(mesh_.twin, h);
    } while (h.exists() && h != outgoing_[v]);
  }

  const SeamMesh& mesh_;
  const IdVector<SurfaceVertex, SurfaceCorner> outgoing_;
  IdVector<SurfaceVertex, std::uint32_t> degree_;
};

void findEdgeImages(const SeamMesh& mesh, const VertexImages& vertex, const Listener& listener,
                    Mirror& out) {
  const EdgeFinder finder(mesh);
  IdVector<SurfaceCorner, SurfaceCorner> found(mesh.twin.size());
  out.image.resize(mesh.twin.size());
  out.around.resize(mesh.twin.size());
  for (const SurfaceCorner h : mesh.corners()) {
    listener.beat();
    const SurfaceVertex tail = vertex[mesh.tail(h)], head = vertex[mesh.head(h)];
    if (!finder.mayBeCut(h) || h > mesh.twin[h] || !tail.exists() || !head.exists()) continue;
    found[h] = finder.between(tail, head);
    if (found[h].exists())
      found[mesh.twin[h]] = mesh.twin[found[h]];
    else
      out.around[h] = finder.around(tail, head);
    if (!out.around[h][0].exists()) continue;
    out.around[mesh.twin[h]] = {mesh.twin[out.around[h][1]], mesh.twin[out.around[h][0]]};
  }
  // Where two edges join the same vertices, each needs its own image.
  for (const SurfaceCorner h : mesh.corners())
    if (found[h].exists() && found[found[h]] == h) out.image[h] = found[h];
}

double mirroredArea(const SeamMesh& mesh, const VertexImages& image) {
  double out = 0;
  for (const SurfaceVertex v : mesh.vertices())
    if (image[v].exists()) out += mesh.vertexArea[v];
  return out;
}

/// By length; those that may not be cut do not matter.
double mirroredEdges(const SeamMesh& mesh, const IdVector<SurfaceCorner, SurfaceCorner>& image) {
  double all = 0, mirrored = 0;
  for (const SurfaceCorner h : mesh.corners()) {
    if (!mesh.twin[h].exists() || !(mesh.cost[h] < kBarredCost)) continue;
    all += mesh.length[h];
    if (image[h].exists()) mirrored += mesh.length[h];
  }
  return all > 0 ? mirrored / all : 0;
}

void findSides(const SeamMesh& mesh, const MirrorPlane& plane, const VertexImages& image,
               Mirror& out) {
  double unmatched = 0;  // on the side 1, less that on the other one
  for (const SurfaceVertex v : mesh.vertices()) {
    const double off = plane.of(placeOf(mesh, v));
    out.side.push_back(static_cast<std::int8_t>(image[v] == v || off == 0 ? 0 : off > 0 ? 1 : -1));
    if (!image[v].exists()) unmatched += out.side[v] * mesh.vertexArea[v];
  }
  if (unmatched > 0)
    for (std::int8_t& side : out.side) side = static_cast<std::int8_t>(-side);
}

}  // namespace

Mirror Mirror::ofPart(const SeamPart& part) const {
  Mirror out;
  if (!*this) return out;
  out.side = part.ofVertices(side);
  IdVector<SurfaceCorner, SurfaceCorner> inPart(image.size());
  for (const SurfaceCorner h : part.wholeHalfEdge.ids()) inPart[part.wholeHalfEdge[h]] = h;
  // An edge that the part is open along has no image, and is none.
  const auto moved = [&](SurfaceCorner h) {
    const SurfaceCorner i = h.exists() ? inPart[h] : SurfaceCorner();
    return i.exists() && part.mesh.twin[i].exists() ? i : SurfaceCorner();
  };
  for (const SurfaceCorner h : part.wholeHalfEdge) {
    if (!moved(h).exists()) {
      out.image.push_back({});
      out.around.push_back({});
      continue;
    }
    out.image.push_back(moved(image[h]));
    const auto [first, second] = around[h];
    const bool isBoth = moved(first).exists() && moved(second).exists();
    out.around.push_back(
        {isBoth ? moved(first) : SurfaceCorner(), isBoth ? moved(second) : SurfaceCorner()});
  }
  return out;
}

Mirror Mirror::ofWhole(const SeamPart& part) const {
  Mirror out;
  if (!*this) return out;
  out.side = part.toWhole(side);
  const auto moved = [&](SurfaceCorner h) {
    return h.exists() ? part.wholeHalfEdge[h] : SurfaceCorner();
  };
  out.image.resize(image.size());
  out.around.resize(image.size());
  for (const SurfaceCorner h : image.ids()) {
    out.image[moved(h)] = moved(image[h]);
    out.around[moved(h)] = {moved(around[h][0]), moved(around[h][1])};
  }
  return out;
}

Mirror findMirror(const SeamMesh& mesh, const Listener& listener) {
  constexpr double kCell = 4 * kMirrorTolerance;
  const VertexCells cells(mesh, kCell);
  const std::optional<MirrorPlane> plane = findMirrorPlane(mesh, cells, listener);
  if (!plane) return {};
  const VertexImages image = vertexImages(mesh, cells, *plane, listener);
  if (mirroredArea(mesh, image) < kLeastMirroredArea * mesh.totalArea()) return {};
  Mirror out;
  findSides(mesh, *plane, image, out);
  findEdgeImages(mesh, image, listener, out);
  return mirroredEdges(mesh, out.image) < kLeastMirroredEdges ? Mirror() : out;
}

}  // namespace abflat
