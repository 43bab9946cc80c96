#pragma once

#include "support/meshes.h"

namespace abflat::test {

/// Unit squares of a columns x rows grid where `isThere` is true, each split in two.
template <typename IsThere>
PolygonMesh squares(std::uint32_t columns, std::uint32_t rows, IsThere isThere) {
  std::vector<double> p;
  std::vector<std::uint32_t> t;
  for (std::uint32_t j = 0; j <= rows; ++j)
    for (std::uint32_t i = 0; i <= columns; ++i) p.insert(p.end(), {double(i), double(j), 0});
  for (std::uint32_t j = 0; j < rows; ++j)
    for (std::uint32_t i = 0; i < columns; ++i) {
      if (!isThere(i, j)) continue;
      const std::uint32_t a = j * (columns + 1) + i, b = a + columns + 1;
      t.insert(t.end(), {a, a + 1, b + 1, a, b + 1, b});
    }
  return makeTriangleMesh(p, t);
}

/// Steps as high as they are wide.
inline PolygonMesh stairs(std::uint32_t n) {
  PolygonMesh mesh = squares(2 * n, n, [](auto, auto) { return true; });
  for (std::size_t v = 0; v < mesh.vertexCount(); ++v) {
    const double i = std::floor(mesh.positions[3 * v] / 2);
    const bool isHigher = std::fmod(mesh.positions[3 * v], 2) > 0;
    mesh.positions[3 * v] = i;
    mesh.positions[3 * v + 2] = i + isHigher;
  }
  return mesh;
}

}  // namespace abflat::test
