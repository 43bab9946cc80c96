#include "mesh/notches.h"

#include <cmath>

#include "base/constants.h"
#include "mesh/triangle_geometry.h"

namespace abflat {
namespace {

/// Sum of the face angles at the vertex where a boundary half-edge begins.
double angleAt(const PolygonMesh& mesh, const CornerTable& table, SurfaceCorner h) {
  double sum = 0;
  for (SurfaceCorner c = h; c.exists(); c = rotateCounterClockwise(table.twin, c))
    sum +=
        cornerAngles(mesh.positions, verticesOf(table.vertex, triangleOf(c)))[placeInTriangle(c)];
  return sum;
}

}  // namespace

VertexPairs findNotches(const PolygonMesh& mesh, const Surface& surface) {
  constexpr double kNothing = 0x1p-40;  // relative to the edge; a sine of pi is less
  constexpr double kBent = 0.3;         // from a full turn; a corner of a dodecahedron: 0.63
  constexpr std::size_t kLeast = 3;     // edges that must be left of a boundary
  VertexPairs out;
  for (const SurfaceLoop& loop : surface.boundaryLoops) {
    const std::size_t n = loop.size(), before = out.size();
    const auto vertexAt = [&](std::size_t i) { return surface.table.vertex[loop[i % n]]; };
    const auto distance = [&](InputVertex v, InputVertex w) {
      return norm(edgeVector(mesh.positions, v, w));
    };
    for (std::size_t i = 0; i < n; ++i) {
      const InputVertex first = vertexAt(i + n - 1), end = vertexAt(i), last = vertexAt(i + 1);
      const double nothing = kNothing * distance(first, end);
      const bool isLonger = distance(vertexAt(i + n - 2), vertexAt(i + 2)) <= nothing;
      if (first == last || distance(first, last) > nothing || isLonger) continue;
      if (std::abs(angleAt(mesh, surface.table, loop[i]) - 2 * kPi) < kBent)
        out.push_back({first, last});
    }
    if (n < 2 * (out.size() - before) + kLeast) out.resize(before);
  }
  return out;
}

}  // namespace abflat
