#include "mesh/smooth_noise.h"

#include <array>
#include <utility>

#include "base/long_sum.h"
#include "mesh/triangle_geometry.h"

namespace abflat {
namespace {

constexpr int kRounds = 16;
/// Of its area, a part must lose that much to count as noisy, and keep that much.
constexpr double kLeastLost = 0.1, kLeastKept = 0.25;
/// And that much must be left of its bends at most: what is thin loses area, too, but stays as
/// bent.
constexpr double kMostBent = 0.75;
/// With fewer, its steps are its shape.
constexpr std::size_t kLeastTriangles = 1000;

/// The edges along which each vertex is pulled: all of those around it where the surface is closed,
/// elsewhere those of its boundary, so that what ends at the vertex does not pull.
class Pulls {
 public:
  Pulls(const Surface& surface, std::size_t vertices) : offset_(vertices + 1, 0) {
    const CornerTable& table = surface.table;
    IdVector<SurfaceVertex, std::uint8_t> isOpen(surface.fans.inputVertex.size(), 0);
    for (const SurfaceCorner h : table.corners())
      if (!table.twin[h].exists())
        isOpen[surface.fans.ofCorner[h]] = isOpen[surface.fans.ofCorner[nextCorner(h)]] = 1;
    std::vector<std::uint8_t> hasClosed(vertices, 0);
    for (const SurfaceCorner h : table.corners())
      if (!isOpen[surface.fans.ofCorner[h]]) hasClosed[table.vertex[h]] = 1;
    const auto visit = [&](const auto& pull) {
      for (const SurfaceCorner h : table.corners()) {
        const InputVertex from = table.vertex[h], to = table.vertex[nextCorner(h)];
        if (!isOpen[surface.fans.ofCorner[h]]) pull(from, to);
        if (table.twin[h].exists()) continue;
        if (!hasClosed[from]) pull(from, to);
        if (!hasClosed[to]) pull(to, from);
      }
    };
    visit([&](InputVertex from, InputVertex) { ++offset_[from + 1]; });
    for (std::size_t v = 0; v < vertices; ++v) offset_[v + 1] += offset_[v];
    std::vector<std::uint32_t> next(offset_.begin(), offset_.end() - 1);
    to_.resize(offset_.back());
    visit([&](InputVertex from, InputVertex to) { to_[next[from]++] = to; });
  }

  /// The middle of the vertices that pull, in whatever order they are; the vertex itself if none
  /// do.
  Vec3 middle(const std::vector<double>& positions, std::size_t v) const {
    Vec3 out;
    const std::uint32_t begin = offset_[v], end = offset_[v + 1];
    for (std::size_t d = 0; d < 3; ++d) {
      LongSum sum;
      for (std::uint32_t i = begin; i < end; ++i) sum.add(positions[3 * std::size_t{to_[i]} + d]);
      out[d] = begin == end ? positions[3 * v + d] : sum.value() / (end - begin);
    }
    return out;
  }

 private:
  std::vector<std::uint32_t> offset_, to_;  ///< by vertex
};

/// `positions` after one round, no farther than `reach` from where they were at `first`.
std::vector<double> pulled(const Pulls& pulls, const std::vector<double>& first,
                           const std::vector<double>& positions, double reach) {
  constexpr double kStep = 0.5;
  std::vector<double> out(positions.size());
  for (std::size_t v = 0; v < positions.size() / 3; ++v) {
    const Vec3 middle = pulls.middle(positions, v);
    Vec3 move;
    for (std::size_t d = 0; d < 3; ++d) {
      const double x = positions[3 * v + d];
      move[d] = x + kStep * (middle[d] - x) - first[3 * v + d];
    }
    const double length = norm(move), share = length > reach ? reach / length : 1;
    for (std::size_t d = 0; d < 3; ++d) out[3 * v + d] = first[3 * v + d] + share * move[d];
  }
  return out;
}

/// What smoothing does to a component.
struct Change {
  LongSum areaBefore, areaAfter;
  LongSum bendBefore, bendAfter;  ///< of edges, times their length
  std::size_t triangles = 0;

  bool mayBeNoise() const {
    const double kept = areaAfter.value() / areaBefore.value();
    return triangles >= kLeastTriangles && kept > kLeastKept && kept < 1 - kLeastLost;
  }
  bool isNoise() const {
    return mayBeNoise() && bendAfter.value() < kMostBent * bendBefore.value();
  }
};

using Changes = IdVector<ComponentId, Change>;

Changes areaChanges(const CornerTable& table, const Components& components,
                    const std::vector<double>& before, const std::vector<double>& after) {
  Changes out(components.firstTriangle.size());
  for (const SurfaceTriangle f : table.triangles()) {
    const TriangleVertices v = verticesOf(table.vertex, f);
    Change& change = out[components.ofTriangle[f]];
    change.areaBefore.add(areaOf(before, v));
    change.areaAfter.add(areaOf(after, v));
    ++change.triangles;
  }
  return out;
}

double bendAt(const CornerTable& table, const std::vector<double>& positions, SurfaceCorner h) {
  const auto normal = [&](SurfaceCorner c) {
    return unitNormal(positions, verticesOf(table.vertex, triangleOf(c)));
  };
  return angleBetween(normal(h), normal(table.twin[h])) *
         norm(edgeVector(positions, table.vertex[h], table.vertex[nextCorner(h)]));
}

/// Only of components that may be noise.
void addBends(const CornerTable& table, const Components& components,
              const std::vector<double>& before, const std::vector<double>& after,
              Changes& changes) {
  IdVector<ComponentId, std::uint8_t> isAsked;
  for (const Change& change : changes) isAsked.push_back(change.mayBeNoise());
  for (const SurfaceCorner h : table.corners()) {
    const ComponentId c = components.ofTriangle[triangleOf(h)];
    if (!isAsked[c] || !table.twin[h].exists() || table.twin[h] < h) continue;
    changes[c].bendBefore.add(bendAt(table, before, h));
    changes[c].bendAfter.add(bendAt(table, after, h));
  }
}

}  // namespace

Smoothed smoothNoise(const PolygonMesh& mesh, const Surface& surface, double reach,
                     const Listener& listener) {
  const CornerTable& table = surface.table;
  const Pulls pulls(surface, mesh.vertexCount());
  Smoothed out{mesh.positions, 0};
  for (int k = 0; k < kRounds && listener.beat(table.vertex.size()); ++k)
    out.positions = pulled(pulls, mesh.positions, out.positions, reach);
  const Components components = findComponents(table);
  Changes changes = areaChanges(table, components, mesh.positions, out.positions);
  addBends(table, components, mesh.positions, out.positions, changes);
  std::vector<std::uint8_t> isNoisy(mesh.vertexCount(), 0);  // so are parts that end there
  for (const SurfaceTriangle f : table.triangles()) {
    if (!changes[components.ofTriangle[f]].isNoise()) continue;
    ++out.triangles;
    for (const std::uint32_t v : verticesOf(table.vertex, f)) isNoisy[v] = 1;
  }
  for (std::size_t i = 0; i < out.positions.size(); ++i)
    if (!isNoisy[i / 3]) out.positions[i] = mesh.positions[i];
  return out;
}

}  // namespace abflat
