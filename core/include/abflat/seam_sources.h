#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "abflat/export.h"
#include "abflat/status.h"

namespace abflat {

/// An edge, given by its two input vertices.
using EdgeVertices = std::array<std::uint32_t, 2>;

/// Where a mesh is cut, beyond what makes every chart a topological disk.
struct SeamSources {
  bool isAuto = true;             ///< cut where charts would be stretched too much or overlap
  double sharpDegrees = 180;      ///< cut along edges that bend by more than this
  bool followsHardEdges = false;  ///< cut where shading normals differ by more than 1 degree
  bool followsTexcoords = false;  ///< cut between the uv islands that the mesh already has
  bool followsMaterials = false;  ///< cut where two materials meet
  std::vector<EdgeVertices> edges;
};

/// Parses a list of sources such as "auto,sharp=60": "auto", "hard", "uv", "material",
/// "none" or "sharp=DEGREES", which is above 0 and at most 180. Errors: InvalidOption.
ABFLAT_API Result<SeamSources> parseSeams(std::string_view text);

}  // namespace abflat
