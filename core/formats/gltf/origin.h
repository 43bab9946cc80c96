#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "abflat/mesh.h"

namespace abflat::gltf {

/// How the positions of a mesh are stored in single precision, which is all that glTF offers.
struct Origin {
  std::array<double, 3> offset{};  ///< translation of all nodes, a single precision number each
  double error = 0;                ///< how far a coordinate is from where it was, at most
  double unmoved = 0;              ///< the same without an offset
  bool isVisible = false;          ///< whether what remains shows
};

/// The offset is 0 along each axis on which the mesh is no further from the origin than it is
/// large, and everywhere if rounding shows nowhere. It shows if more than one edge in a hundred
/// changes by more than a thousandth of its length. `triangleCorners` are as for makeGltf.
Origin originOf(const PolygonMesh& mesh, const std::vector<std::uint32_t>& triangleCorners);

}  // namespace abflat::gltf
