#pragma once

#include <string>
#include <vector>

#include "abflat/mesh.h"

namespace abflat::test {

struct ClosedMesh {
  std::string family;
  int genus;  ///< summed over its parts; -1 if it is random
  PolygonMesh mesh;
};

constexpr unsigned kClosedFamilies = 10;

/// Small closed surfaces: blobs, tori, chains of rings, sponges, boxes, plates, polyhedra, spheres
/// with poles, stars, and several parts together. `number` modulo kClosedFamilies selects the
/// family.
ClosedMesh closedMesh(unsigned number);

}  // namespace abflat::test
