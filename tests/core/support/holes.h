#pragma once

#include <algorithm>
#include <functional>
#include <random>
#include <vector>

#include "abflat/mesh.h"

namespace abflat::test {

/// Removes the faces for which `isGone` is true; vertices without faces stay.
inline PolygonMesh punched(const PolygonMesh& mesh,
                           const std::function<bool(std::uint32_t)>& isGone) {
  std::vector<std::uint32_t> indices;
  for (std::uint32_t f = 0; f < mesh.faceCount(); ++f) {
    if (isGone(f)) continue;
    indices.insert(indices.end(), &mesh.faceVertices[3 * f], &mesh.faceVertices[3 * f] + 3);
  }
  return makeTriangleMesh(mesh.positions, std::move(indices));
}

/// Cuts a window of `size` squares into the middle of each block of `block` squares of a grid (or
/// tube) with the given number of columns.
inline PolygonMesh windowed(const PolygonMesh& grid, unsigned columns, unsigned block,
                            unsigned size) {
  return punched(grid, [=](std::uint32_t f) {
    const auto isInside = [=](unsigned i) {
      const unsigned first = (block - size) / 2;
      return i % block >= first && i % block < first + size;
    };
    return isInside(f / 2 % columns) && isInside(f / 2 / columns);
  });
}

/// Removes about every n-th triangle.
inline PolygonMesh motheaten(const PolygonMesh& mesh, unsigned n, unsigned seed) {
  std::mt19937 random(seed);
  return punched(mesh, [&](std::uint32_t) { return random() % n == 0; });
}

}  // namespace abflat::test
