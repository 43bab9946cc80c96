#pragma once

#include <functional>

#include "abflat/mesh.h"

namespace abflat::test {

using Field = std::function<double(double x, double y, double z)>;

/// The surface field = 0 inside the cube [-1, 1]^3, by marching tetrahedra on a grid of cells^3,
/// with the negative side inside. It is a manifold, oriented outwards, and open only where it
/// leaves the cube.
PolygonMesh isosurface(unsigned cells, const Field& field);

/// Closed surface of a chain of `genus` rings (a sphere if 0).
Field rings(unsigned genus);

/// Smooth noise with `frequency` bumps across the cube, confined to it: closed, of high genus.
Field noise(double frequency, unsigned seed);

}  // namespace abflat::test
