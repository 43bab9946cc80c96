#pragma once

#include <vector>

#include "abflat/mesh.h"

namespace abflat::scaling {

/// A kind of mesh that has made a stage slow, in any size.
struct Family {
  const char* name;
  PolygonMesh (*make)(unsigned faces);  ///< of about that many faces
};

const std::vector<Family>& families();

}  // namespace abflat::scaling
