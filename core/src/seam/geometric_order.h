#pragma once

#include "seam/extract_charts.h"

namespace abflat {

/// The same surface with triangles, corners and vertices in an order that depends on its shape, not
/// on its numbers. Where several places have the same surroundings, as on a cube, any of them may
/// come first.
SeamPart inGeometricOrder(const SeamMesh& mesh, const Listener& listener = {});

}  // namespace abflat
