#include "seam/geometric_order.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/double_bits.h"
#include "base/stable_order.h"
#include "mesh/triangle_walk.h"

namespace abflat {
namespace {

using Colors = IdVector<SurfaceCorner, std::uint64_t>;

std::uint64_t mixed(std::uint64_t a, std::uint64_t b) {
  std::uint64_t x = (a ^ (b + 0x9e3779b97f4a7c15u + (a << 6) + (a >> 2))) * 0xbf58476d1ce4e5b9u;
  x = (x ^ x >> 29) * 0x94d049bb133111ebu;
  return x ^ x >> 32;
}

/// A number per corner that tells what the surface looks like from there: each round looks one
/// triangle farther.
Colors colorsOf(const SeamMesh& mesh, const Listener& listener) {
  constexpr std::size_t kFewest = 4, kMost = 64, kWork = 1000000;
  const std::size_t rounds = std::clamp(kWork / (mesh.corners().size() + 1), kFewest, kMost);
  Colors now(mesh.corners().size(), 0), next(now.size());
  for (const SurfaceCorner h : mesh.corners()) {
    // What fills holes is not measured as well.
    if (mesh.isFilling(triangleOf(h))) continue;
    now[h] = mixed(mixed(bitsOf(mesh.length[h]), bitsOf(mesh.cost[h])), mesh.twin[h].exists());
  }
  for (std::size_t k = 0; k < rounds; ++k) {
    for (const SurfaceCorner h : mesh.corners()) {
      const SurfaceCorner o = mesh.twin[h];
      next[h] = mixed(mixed(now[h], now[nextCorner(h)]), o.exists() ? now[o] : 0);
    }
    std::swap(now, next);
    listener.beat(mesh.corners().size());
  }
  return now;
}

/// By color; corners whose surroundings are the same come in order of where they lie, and by number
/// only if several lie there.
class CornerOrder {
 public:
  CornerOrder(const SeamMesh& mesh, const Colors& colors) : mesh_(mesh), colors_(colors) {}

  bool operator()(SurfaceCorner a, SurfaceCorner b) const {
    if (colors_[a] != colors_[b]) return colors_[a] < colors_[b];
    const std::array<double, 9> p = places(a), q = places(b);
    return p != q ? p < q : a < b;
  }

 private:
  /// On a grid, so that a change of unit makes no difference.
  std::array<double, 9> places(SurfaceCorner h) const {
    constexpr double kGrid = 268435456;  // 2^28 steps over the extent
    std::array<double, 9> out;
    auto* to = out.data();
    for (const SurfaceCorner c : {h, nextCorner(h), prevCorner(h)}) {
      const double* const p = &mesh_.positions[3 * std::size_t{mesh_.vertexOfCorner[c]}];
      to = std::transform(p, p + 3, to, [](double x) { return std::floor(x * kGrid + 0.5); });
    }
    return out;
  }

  const SeamMesh& mesh_;
  const Colors& colors_;
};

/// The first corner of each piece, in order.
std::vector<SurfaceCorner> startsOf(const SeamMesh& mesh, const CornerOrder& isLess) {
  std::vector<SurfaceCorner> out, piece;
  IdVector<SurfaceTriangle, std::uint8_t> isSeen(mesh.triangleCount(), 0);
  for (const SurfaceTriangle f : mesh.triangles()) {
    if (isSeen[f]) continue;
    piece.clear();
    walkTriangles(cornerOf(f, 0), mesh.twin, isSeen, piece);
    SurfaceCorner least = piece.front();
    for (const SurfaceCorner c : piece)
      for (const SurfaceCorner h : cornersOf(triangleOf(c)))
        if (isLess(h, least)) least = h;
    out.push_back(least);
  }
  sortStably(out, isLess);
  return out;
}

/// The first corner of each triangle, in the new order, in which those that fill holes come last.
std::vector<SurfaceCorner> firstCorners(const SeamMesh& mesh, const Colors& colors) {
  std::vector<SurfaceCorner> all, out;
  IdVector<SurfaceTriangle, std::uint8_t> isSeen(mesh.triangleCount(), 0);
  for (const SurfaceCorner start : startsOf(mesh, CornerOrder(mesh, colors)))
    walkTriangles(start, mesh.twin, isSeen, all);
  out.reserve(all.size());
  for (const bool isFilling : {false, true})
    for (const SurfaceCorner c : all)
      if (mesh.isFilling(triangleOf(c)) == isFilling) out.push_back(c);
  return out;
}

void addTriangle(const SeamMesh& mesh, SurfaceCorner first, SeamPart& out) {
  const SurfaceTriangle f = triangleOf(first);
  SeamMesh& m = out.mesh;
  m.area.push_back(mesh.area[f]);
  if (!mesh.hole.empty()) m.hole.push_back(mesh.hole[f]);
  if (!mesh.front.empty()) m.front.push_back(mesh.frontAt(f));
  if (!mesh.excess.empty()) m.excess.push_back(mesh.excess[f]);
  for (const SurfaceCorner h : {first, nextCorner(first), prevCorner(first)}) {
    out.wholeHalfEdge.push_back(h);
    if (!mesh.dearness.empty()) m.dearness.push_back(mesh.dearnessAt(h));
  }
}

void addMeasures(const SeamMesh& mesh, SeamPart& out) {
  SeamMesh& m = out.mesh;
  m.angle = out.ofCorners(mesh.angle);
  m.length = out.ofCorners(mesh.length);
  m.cost = out.ofCorners(mesh.cost);
  m.weight = out.ofCorners(mesh.weight);
}

void addVertices(const SeamMesh& mesh, SeamPart& out) {
  SeamMesh& m = out.mesh;
  IdVector<SurfaceVertex, SurfaceVertex> now(mesh.vertexCount());
  for (const SurfaceCorner h : out.wholeHalfEdge) {
    const SurfaceVertex v = mesh.vertexOfCorner[h];
    if (!now[v].exists()) {
      const double* const p = &mesh.positions[3 * std::size_t{v}];
      m.positions.insert(m.positions.end(), p, p + 3);
      out.wholeVertex.push_back(v);
      now[v] = m.vertexArea.push_back(0);
      m.angleSum.push_back(mesh.angleSum[v]);
    }
    m.vertexOfCorner.push_back(now[v]);
    m.vertexArea[now[v]] += mesh.area[triangleOf(h)] / 3;
  }
}

}  // namespace

SeamPart inGeometricOrder(const SeamMesh& mesh, const Listener& listener) {
  SeamPart out;
  out.mesh.frontLeeway = mesh.frontLeeway;
  for (const SurfaceCorner first : firstCorners(mesh, colorsOf(mesh, listener)))
    addTriangle(mesh, first, out);
  addMeasures(mesh, out);
  addVertices(mesh, out);
  const IdVector<SurfaceCorner, SurfaceCorner> now = out.cornersInPart(mesh.twin.size());
  for (const SurfaceCorner h : out.wholeHalfEdge) {
    const SurfaceCorner o = mesh.twin[h];
    out.mesh.twin.push_back(o.exists() ? now[o] : SurfaceCorner());
  }
  return out;
}

}  // namespace abflat
