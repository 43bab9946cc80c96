#pragma once

#include "seam/cut_to_disks.h"
#include "seam/find_seams.h"
#include "seam/given_charts.h"
#include "seam/log_scale.h"

namespace abflat {

/// A mesh with the seams that its topology asks for.
struct BegunSearch {
  Seams seams;
  GivenCharts given;
  TopologyCut cut;
};

/// Adds options.first to the seams that are given, and cuts the charts to disks. `doubled`: see
/// doubledEdges; `solver` is of the mesh.
BegunSearch beginSearch(const SeamMesh& mesh, Seams given, const SeamOptions& options,
                        const std::vector<SurfaceCorner>& doubled, LogScale& solver);

}  // namespace abflat
