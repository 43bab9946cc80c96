#include "abflat/pin_weights.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/guarded.h"
#include "base/invalid.h"
#include "base/stable_order.h"
#include "mesh/triangle_geometry.h"
#include "pin/pinned_layout.h"

namespace abflat {
namespace {

Status checkLayout(const PinnedMesh& layout) {
  const std::size_t vertices = layout.mesh.vertexCount();
  if (layout.uv.size() != 2 * vertices)
    return invalid("uv has " + std::to_string(layout.uv.size()) + " numbers, but the mesh has " +
                   std::to_string(vertices) + " vertices, which need two each");
  for (std::size_t i = 0; i < layout.uv.size(); ++i)
    if (!std::isfinite(layout.uv[i]))
      return invalid("the uv of vertex " + std::to_string(i / 2) + " must be two finite numbers");
  if (layout.mesh.faceVertices.size() != 3 * layout.mesh.faceCount())
    return invalid("a face is not a triangle. Triangulate the layout first");
  return {};
}

Status checkPins(const PinnedMesh& layout) {
  const std::vector<std::uint32_t>& pins = layout.pins;
  if (pins.empty()) return invalid("no vertex is pinned. Pin the one that is dragged");
  for (const std::uint32_t v : pins)
    if (v >= layout.mesh.vertexCount())
      return invalid("vertex " + std::to_string(v) + " is pinned, but the mesh has " +
                     std::to_string(layout.mesh.vertexCount()) + " vertices (indices start at 0)");
  std::vector<std::uint32_t> sorted = pins;
  std::sort(sorted.begin(), sorted.end());
  const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
  if (twice != sorted.end())
    return invalid("vertex " + std::to_string(*twice) + " is pinned twice. Name it once");
  const auto isAtFirst = [&](std::uint32_t v) {
    return pointAt(layout.uv, v) == pointAt(layout.uv, pins.front());
  };
  if (pins.size() > 1 && std::all_of(pins.begin(), pins.end(), isAtFirst))
    return invalid(
        "all pinned vertices are at one place, so none can be moved alone. Keep one of them");
  return {};
}

/// Edges of one triangle only, in its direction.
IdVector<BoundaryIndex, ChartCorner> boundaryOf(
    const IdVector<ChartCorner, ChartVertex>& vertexOfCorner) {
  struct Edge {
    ChartVertex low, high;
    ChartCorner corner;
  };
  const auto isBefore = [](const Edge& a, const Edge& b) {
    return a.low != b.low ? a.low < b.low : a.high < b.high;
  };
  std::vector<Edge> edges;
  edges.reserve(vertexOfCorner.size());
  for (const ChartCorner c : vertexOfCorner.ids()) {
    const ChartVertex from = vertexOfCorner[c], to = vertexOfCorner[nextCorner(c)];
    edges.push_back({std::min(from, to), std::max(from, to), c});
  }
  sortStably(edges, isBefore);
  IdVector<BoundaryIndex, ChartCorner> out;
  for (auto first = edges.begin(); first != edges.end();) {
    const auto last = std::upper_bound(first, edges.end(), *first, isBefore);
    if (last - first == 1) out.push_back(first->corner);
    first = last;
  }
  return out;
}

std::vector<double> surfaceAngles(const PolygonMesh& mesh) {
  std::vector<double> out;
  out.reserve(mesh.faceVertices.size());
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    const std::uint32_t* v = &mesh.faceVertices[3 * f];
    const TriangleVertices vertices{v[0], v[1], v[2]};
    const auto angles =
        anglesOrMadeUp(mesh.positions, vertices, cornerAngles(mesh.positions, vertices));
    out.insert(out.end(), angles.begin(), angles.end());
  }
  return out;
}

Result<std::vector<double>> weightsOf(const PinnedMesh& layout) {
  if (Status s = validateArrays(layout.mesh); !s.ok()) return s;
  if (Status s = checkLayout(layout); !s.ok()) return s;
  if (Status s = checkPins(layout); !s.ok()) return s;
  IdVector<ChartCorner, ChartVertex> vertexOfCorner;
  vertexOfCorner.reserve(layout.mesh.faceVertices.size());
  for (const std::uint32_t v : layout.mesh.faceVertices) vertexOfCorner.push_back(ChartVertex(v));
  const IdVector<BoundaryIndex, ChartCorner> boundary = boundaryOf(vertexOfCorner);
  std::vector<ChartPin> pins;
  for (const std::uint32_t v : layout.pins) pins.push_back({ChartVertex(v), pointAt(layout.uv, v)});
  pins.front().uv[0] += 1;
  PinnedLayout moved =
      pinLayout({vertexOfCorner, boundary}, surfaceAngles(layout.mesh), layout.uv, pins);
  if (!moved.isSolved)
    return invalid(
        "the linear system that spreads the pins is numerically singular. Pin other vertices");
  for (std::size_t i = 0; i < moved.uv.size(); ++i) moved.uv[i] -= layout.uv[i];
  return std::move(moved.uv);
}

}  // namespace

Result<std::vector<double>> pinWeights(const PinnedMesh& layout) {
  return guarded([&] { return weightsOf(layout); });
}

}  // namespace abflat
