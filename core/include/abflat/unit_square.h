#pragma once

#include "abflat/export.h"
#include "abflat/flatten.h"

namespace abflat {

/// Moves and scales a layout into [0, 1] x [0, 1], as textures need it, keeping its proportions.
/// The report then describes the moved coordinates; pins, if any, are no longer met.
ABFLAT_API void fitUnitSquare(const PolygonMesh& mesh, FlattenResult& result);

}  // namespace abflat
