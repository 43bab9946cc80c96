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

/// A plate of (2 n + 1)^2 squares and the given thickness, with n^2 square holes through it.
PolygonMesh grille(unsigned n, double thickness);

}  // namespace abflat::test
