#pragma once

#include <vector>

#include "abflat/mesh.h"
#include "mesh/ids.h"

namespace abflat {

/// Corners that get vertices of their own, and the places of these.
struct OpenedCorners {
  struct Corner {
    PolygonCorner corner;
    std::uint32_t point;  ///< index into `positions`, or kNone if it stays where it is
  };
  std::vector<Corner> corners;    ///< in order
  std::vector<double> positions;  ///< x, y, z
};

/// Gives corners at which a face touches itself their new vertices. Faces beside them that fill the
/// same angle share those.
void openCorners(const OpenedCorners& opened, PolygonMesh& mesh);

}  // namespace abflat
