#pragma once

#include <cstdint>
#include <vector>

#include "abflat/mesh.h"

namespace abflat {

constexpr std::uint32_t kNoMatch = 0xffffffffu;

/// Which faces of one mesh are which of another. A polygon may be several triangles there.
struct FaceMatch {
  std::vector<std::uint32_t> face;     ///< per face, that of the other mesh or kNoMatch
  std::vector<std::uint32_t> corner;   ///< per face corner, likewise
  std::vector<std::uint32_t> turned;   ///< faces that run the other way round, ascending
  std::vector<std::uint32_t> missing;  ///< faces of the other mesh, or parts of them, ascending
};

/// Of the bounding box; 0 without positions.
double diagonalOf(const std::vector<double>& positions);

/// Finds the faces of `now` in `was`, where places are the same up to `tolerance`.
FaceMatch matchFaces(const PolygonMesh& was, const PolygonMesh& now, double tolerance);

}  // namespace abflat
