#include "islands/old_aspect.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "mesh/triangle_geometry.h"

namespace abflat {
namespace {

/// The Dirichlet energies of u and of v on a triangle, by cotangents. Not finite without area.
std::array<double, 2> energiesOf(const std::vector<double>& positions, const TriangleVertices& v,
                                 const double* uv, double area) {
  std::array<double, 2> out{};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    const double cotangent =
        dot(edgeVector(positions, v[k], v[i]), edgeVector(positions, v[k], v[j])) / (2 * area);
    for (std::size_t d = 0; d < 2; ++d) {
      const double step = uv[2 * j + d] - uv[2 * i + d];
      out[d] += cotangent * step * step / 2;
    }
  }
  return out;
}

}  // namespace

double oldAspect(const PolygonMesh& mesh, const MappedTriangles& triangles, double aspect) {
  constexpr double kMost = 10;  // of a triangle, which may be flat in uv
  if (aspect == 1) return 1;
  double asSquare = 0, asTile = 0;  // how much squares become rectangles, times area
  for (std::size_t t = 0; t < triangles.corners.size(); ++t) {
    const auto& [a, b, c] = triangles.corners[t];
    const TriangleVertices v = {mesh.faceVertices[a], mesh.faceVertices[b], mesh.faceVertices[c]};
    const double* const uv = &triangles.inUv.uv[6 * t];
    const double area = areaOf(mesh.positions, v), inUv = std::abs(doubleArea(uv));
    const std::array<double, 2> energy = energiesOf(mesh.positions, v, uv, area);
    const auto sheared = [&](double of) {
      return area * std::min((energy[0] * of + energy[1] / of) / inUv, kMost);
    };
    const double square = sheared(1), tile = sheared(aspect);
    if (!std::isfinite(square) || !std::isfinite(tile)) continue;
    asSquare += square;
    asTile += tile;
  }
  return asSquare < asTile ? 1 : aspect;
}

}  // namespace abflat
