#pragma once

#include "abflat/unwrap.h"
#include "mesh/welded_mesh.h"
#include "unwrap/chart.h"
#include "unwrap/rounding.h"

namespace abflat {

/// Decides from the numbers that files have whether the atlas is valid as a whole: every triangle
/// positively oriented, every chart in its tile, no two on each other. A chart that fails gets the
/// problem, and is not valid. `result` is complete, with rows for all charts.
void certify(const WeldedMesh& welded, Numbers numbers, UnwrapResult& result);

/// About polygons that programs fold when they cut them from their first corner, as most do: a
/// sentence, empty where there are none.
std::string foldedFansNote(const PolygonMesh& input, const UnwrapResult& result);

}  // namespace abflat
