#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace abflat {

/// Places where parts of an outline come near each other in the atlas, though they are far apart in
/// space.
struct NearParts {
  /// Edges, from point i to i + 1, at both sides of a gap that is too narrow. Parting all of them
  /// parts the places.
  std::vector<std::array<std::uint32_t, 2>> edges;
  double gap = 0;           ///< the narrowest one
  std::uint32_t point = 0;  ///< a point of the outline there
};

/// Closed polygon, the chart on its left. Units are texels for both.
struct PlacedOutline {
  std::vector<double> uv;         ///< 2 per point
  std::vector<double> positions;  ///< 3 per point, in space
};

/// Parts are too near if the gap between them, outside of the chart, is less than `padding`, and
/// places nearest to each other are more than 4 times that apart in space and 16 times that along
/// the outline. What is nearer in space is mixed by filtering anyway, such as the two sides of a
/// seam that ends in the chart; and the two sides of a notch always meet at its end. Looks at
/// places at most two paddings apart, and only at some where very many are near. Close to linear if
/// few are near.
NearParts findNearParts(const PlacedOutline& outline, double padding);

}  // namespace abflat
