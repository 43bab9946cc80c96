#pragma once

#include "abflat/unwrap.h"
#include "mesh/input_mesh.h"
#include "mesh/welded_mesh.h"
#include "unwrap/chart.h"
#include "unwrap/rounding.h"

namespace abflat {

/// Decides from the numbers as written to files whether the whole atlas is valid: every triangle
/// positively oriented, every chart within its tile, no two charts overlapping. A chart that fails
/// gets a problem and is no longer valid. `result` is complete, with rows for all charts.
void certify(const InputMesh& input, const WeldedMesh& welded, Numbers numbers,
             UnwrapResult& result);

/// A sentence about polygons that fold over in programs that triangulate them as a fan from the
/// first corner, as most do. Empty if there are none.
std::string foldedFansNote(const InputMesh& input, const UnwrapResult& result);

}  // namespace abflat
