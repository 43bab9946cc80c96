#pragma once

#include <array>

#include "bake/colour.h"

namespace abflat {

/// A normal and tangents across it as they are interpolated, of any length.
struct TangentFrames {
  std::array<double, 3> normal{};
  std::array<double, 4> oldTangent{}, tangent{};  ///< with the sign of the bitangent
};

/// Takes a vector of a normal map from the old frame to the new one, where it is a unit vector.
Colour turnedNormal(const Colour& vector, const TangentFrames& frames);

}  // namespace abflat
