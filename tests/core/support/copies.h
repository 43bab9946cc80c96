#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "support/meshes.h"

namespace abflat::test {

/// A moving, turning and perhaps mirroring of space.
struct Motion {
  std::array<std::array<double, 3>, 3> axes;
  std::array<double, 3> shift;

  std::array<double, 3> operator()(const double* p) const {
    std::array<double, 3> out = shift;
    for (std::size_t d = 0; d < 3; ++d)
      for (std::size_t k = 0; k < 3; ++k) out[d] += axes[d][k] * p[k];
    return out;
  }
};

inline Motion randomMotion(std::mt19937& random, bool isMirrored) {
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> place(-50, 50);
  std::array<double, 4> q{};
  double square = 0;
  for (double& x : q) {
    x = normal(random);
    square += x * x;
  }
  for (double& x : q) x /= std::sqrt(square);
  const auto [w, x, y, z] = q;
  Motion out{{{{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
               {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
               {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}}},
             {place(random), place(random), place(random)}};
  if (isMirrored)
    for (auto& row : out.axes) row[0] = -row[0];
  return out;
}

/// The mesh moved, in single precision as files hold it. Mirrored, its faces are turned so that
/// their outer side stays outside.
inline PolygonMesh moved(PolygonMesh mesh, const Motion& motion, bool isMirrored) {
  for (std::size_t v = 0; v < mesh.vertexCount(); ++v) {
    const std::array<double, 3> p = motion(&mesh.positions[3 * v]);
    for (std::size_t d = 0; d < 3; ++d) mesh.positions[3 * v + d] = static_cast<float>(p[d]);
  }
  for (std::size_t f = 0; isMirrored && f < mesh.faceCount(); ++f)
    std::reverse(mesh.faceVertices.begin() + mesh.faceOffsets[f],
                 mesh.faceVertices.begin() + mesh.faceOffsets[f + 1]);
  return mesh;
}

inline void append(PolygonMesh& mesh, const PolygonMesh& other) {
  const auto vertices = static_cast<std::uint32_t>(mesh.vertexCount());
  const auto corners = static_cast<std::uint32_t>(mesh.faceVertices.size());
  mesh.positions.insert(mesh.positions.end(), other.positions.begin(), other.positions.end());
  for (const std::uint32_t v : other.faceVertices) mesh.faceVertices.push_back(vertices + v);
  if (mesh.faceOffsets.empty()) mesh.faceOffsets.push_back(0);
  for (std::size_t f = 1; f < other.faceOffsets.size(); ++f)
    mesh.faceOffsets.push_back(corners + other.faceOffsets[f]);
}

/// That many copies, moved and renumbered at random, every second one mirrored if asked for.
inline PolygonMesh copies(const PolygonMesh& mesh, unsigned count, unsigned seed,
                          bool areMirrored = false) {
  std::mt19937 random(seed);
  PolygonMesh out;
  for (unsigned i = 0; i < count; ++i) {
    const bool isMirrored = areMirrored && i % 2 == 1;
    const PolygonMesh part = renumbered(mesh, seed + i).mesh;
    append(out, moved(part, randomMotion(random, isMirrored), isMirrored));
  }
  return out;
}

/// A wedge of quads, unlike its mirror image.
inline PolygonMesh wedge() {
  PolygonMesh out;
  out.positions = {0, 0, 0, 3, 0, 0, 3, 2, 0, 0, 1, 0, 0, 0, 1, 3, 0, .5, 3, 2, 1.5, 0, 1, 1};
  out.faceVertices = {0, 3, 2, 1, 4, 5, 6, 7, 0, 1, 5, 4, 1, 2, 6, 5, 2, 3, 7, 6, 3, 0, 4, 7};
  out.faceOffsets = {0, 4, 8, 12, 16, 20, 24};
  return out;
}

}  // namespace abflat::test
