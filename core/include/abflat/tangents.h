#pragma once

#include <vector>

#include "abflat/export.h"

namespace abflat {

/// Triangles, listed corner by corner, three to a triangle. All numbers are finite.
struct TangentInput {
  std::vector<double> positions;  ///< 3 per corner
  std::vector<float> normals;     ///< 3 per corner, of length 1
  std::vector<double> uv;         ///< 2 per corner; as in glTF, v grows downwards
};

/// The tangents of MikkTSpace, which normal maps are made for: 4 numbers per corner, a unit vector
/// across the normal and the sign w of the bitangent w * cross(normal, tangent). As green means in
/// glTF, the bitangent points to where v is smaller. Corners with equal position, normal and uv,
/// joined by edges with faces that are not mirrored to each other, have the same tangent. Corners
/// of faces without area take that of others in their place, or any.
ABFLAT_API std::vector<float> mikkTangents(const TangentInput& input);

}  // namespace abflat
