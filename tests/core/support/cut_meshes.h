#pragma once

#include <vector>

#include "abflat/mesh.h"
#include "mesh/surface.h"
#include "seam/find_seams.h"

namespace abflat::test {

/// A mesh ready to be cut.
struct Cuttable {
  PolygonMesh mesh;
  Surface surface;
  SeamMesh seamMesh;

  explicit Cuttable(PolygonMesh polygons, SeamCosts costs = SeamCosts::Sight);
};

/// The charts as meshes of their own, found by joining corners and triangles across edges that are
/// not seams, independently of how seams are found.
std::vector<PolygonMesh> chartsOf(const Cuttable& cuttable, const Seams& seams);

}  // namespace abflat::test
