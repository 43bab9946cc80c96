#pragma once

#include "abflat/unwrap.h"
#include "unwrap/cut_mesh.h"

namespace abflat {

/// Checks UnwrapOptions::faceDensities of a mesh with that many faces. Errors: InvalidOption.
Status checkDensities(const std::vector<double>& ofFace, std::size_t faces);

/// Per chart, its texel density relative to that of other charts: it gets as many texels as its
/// faces ask for together. Empty if none is asked for. `positions`: of the vertices on the true
/// surface, if charts are drawn after a smoothed one; otherwise empty.
IdVector<ChartId, double> densitiesOf(const CutMesh& mesh, const std::vector<double>& ofFace,
                                      const std::vector<double>& positions);

}  // namespace abflat
