#pragma once

#include <functional>

#include "abflat/mesh.h"

namespace abflat::test {

using Field = std::function<double(double x, double y, double z)>;

/// The surface field = 0 inside the cube [-1, 1]^3 on a grid of cells^3 by marching tetrahedra, the
/// negative side inside: a manifold, oriented outwards, open only where it leaves the cube.
PolygonMesh isosurface(unsigned cells, const Field& field);

/// Closed surface of a chain of `genus` rings (a sphere for none).
Field rings(unsigned genus);

/// Smooth noise with `frequency` bumps along the cube, kept inside of it: closed, of high genus.
Field noise(double frequency, unsigned seed);

}  // namespace abflat::test
