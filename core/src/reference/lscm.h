#pragma once

#include <Eigen/SparseCore>
#include <array>

#include "layout/convex_combination.h"

namespace abflat {

/// Twice the conformal energy of Lévy et al. 2002 as a quadratic form x^T E x: Dirichlet energy
/// minus uv area, twice each. x has size 2V: all u, then all v. Positive semidefinite; 0 where
/// every triangle is similar to itself in 3D.
Eigen::SparseMatrix<double> conformalEnergy(const DiskChart& chart);

/// Two boundary vertices far apart in 3D: the farthest from the middle of the boundary, and the
/// farthest from that one. Independent of the numbering, up to ties.
std::array<std::uint32_t, 2> findPins(const DiskChart& chart);

/// Lévy, Petitjean, Ray, Maillot: "Least squares conformal maps for automatic texture atlas
/// generation", 2002. The boundary is free, two pins on the u axis fix position, rotation and size.
/// Triangles may flip and the boundary may cross itself.
Embedding embedLscm(const DiskChart& chart);

}  // namespace abflat
