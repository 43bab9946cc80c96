#include "islands/old_aspect.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace abflat {
namespace {

using Step = std::array<double, 3>;

Step stepBetween(const PolygonMesh& mesh, std::uint32_t from, std::uint32_t to) {
  Step out{};
  for (std::size_t d = 0; d < 3; ++d)
    out[d] = mesh.positions[3 * std::size_t{mesh.faceVertices[to]} + d] -
             mesh.positions[3 * std::size_t{mesh.faceVertices[from]} + d];
  return out;
}

double dotOfSteps(const Step& a, const Step& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

double doubleAreaBetween(const Step& a, const Step& b) {
  return std::sqrt(
      std::max(dotOfSteps(a, a) * dotOfSteps(b, b) - dotOfSteps(a, b) * dotOfSteps(a, b), 0.0));
}

}  // namespace

double oldAspect(const PolygonMesh& mesh, const MappedTriangles& triangles, double aspect) {
  constexpr double kMost = 10;  // of a triangle, which may be flat in uv
  if (aspect == 1) return 1;
  double asSquare = 0, asTile = 0;  // how much squares become rectangles, times area
  for (std::size_t t = 0; t < triangles.corners.size(); ++t) {
    const double* const uv = &triangles.inUv.uv[6 * t];
    double along[2] = {}, area = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
      const auto& corners = triangles.corners[t];
      const Step a = stepBetween(mesh, corners[k], corners[i]);
      const Step b = stepBetween(mesh, corners[k], corners[j]);
      area = doubleAreaBetween(a, b);
      for (std::size_t d = 0; d < 2; ++d) {
        const double length = uv[2 * j + d] - uv[2 * i + d];
        along[d] +=
            dotOfSteps(a, b) / area * length * length / 2;  // what cotangents say of the gradient
      }
    }
    const double inUv = std::abs(doubleArea(uv));
    const auto sheared = [&](double of) {
      return std::min((along[0] * of + along[1] / of) / inUv, kMost);
    };
    const double square = area * sheared(1), tile = area * sheared(aspect);
    if (!std::isfinite(square) || !std::isfinite(tile)) continue;
    asSquare += square;
    asTile += tile;
  }
  return asSquare < asTile ? 1 : aspect;
}

}  // namespace abflat
