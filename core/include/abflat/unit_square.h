#pragma once

#include "abflat/flatten.h"

namespace abflat {

/// Moves and scales a layout into [0, 1] x [0, 1], as textures need it, and keeps its proportions.
/// The report is about the moved coordinates then; its pins, if any, are no longer met.
void fitUnitSquare(const PolygonMesh& mesh, FlattenResult& result);

}  // namespace abflat
