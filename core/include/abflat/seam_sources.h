#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "abflat/status.h"

namespace abflat {

/// An edge by its vertices, those of the input.
using EdgeVertices = std::array<std::uint32_t, 2>;

/// Where a mesh is cut, beyond what makes every chart a topological disk.
struct SeamSources {
  bool isAuto = true;             ///< where charts would be stretched too much or overlap
  double sharpDegrees = 180;      ///< along edges that bend by more
  bool followsTexcoords = false;  ///< between the islands that the mesh has
  bool followsMaterials = false;  ///< where two materials meet
  std::vector<EdgeVertices> edges;
};

/// The sources in a list such as "auto,sharp=60": "auto", "uv", "material", "none" or
/// "sharp=DEGREES", which is above 0 and at most 180. Errors: InvalidOption.
Result<SeamSources> parseSeams(std::string_view text);

}  // namespace abflat
