#pragma once

#include <array>
#include <random>
#include <string>
#include <vector>

#include "abflat/mesh.h"

namespace abflat::test {

/// Height field over a (columns x rows) grid of squares, each split in two, with random heights and
/// sideways jitter.
PolygonMesh bumpyGrid(unsigned columns, unsigned rows, double height, unsigned seed);

/// Grid whose opposite sides are joined: closed, genus 1.
PolygonMesh torus(unsigned columns, unsigned rows);

/// Grid with the left and right sides joined: two boundary loops.
PolygonMesh cylinder(unsigned columns, unsigned rows);

/// A sphere as modelling programs make it: a disk, with vertices doubled along a meridian and one
/// pole vertex for each triangle there. In single precision the poles and the meridian are only
/// nearly closed.
PolygonMesh uvSphere(unsigned columns, unsigned rows);

/// A ball with hollows around a direction, as eyes, cheeks and a mouth.
PolygonMesh dentedBall(const std::array<double, 3>& toward);

PolygonMesh tetrahedron();

/// Fan of n triangles around vertex 0, with all outer edges on the boundary; the apex has the given
/// height.
PolygonMesh cone(unsigned n, double height);

/// A concave planar polygon: a star of 2n corners as a single face.
PolygonMesh star(unsigned n);

/// x -> scale * R x + shift with a fixed, irrational-looking rotation R.
PolygonMesh transformed(const PolygonMesh& mesh, double scale, const std::array<double, 3>& shift);

/// The same mesh with vertices and faces in random order and each face starting at a random corner.
struct Renumbered {
  PolygonMesh mesh;
  std::vector<std::uint32_t> vertex;  ///< old vertex -> new vertex
  std::vector<std::uint32_t> corner;  ///< old face corner -> new face corner
};
Renumbered renumbered(const PolygonMesh& mesh, unsigned seed);

/// The same mesh with a vertex of its own for each corner.
PolygonMesh exploded(const PolygonMesh& mesh);

/// A mesh of the shared collection beside the project; empty, with a message, if that folder does
/// not exist.
PolygonMesh sharedMesh(const std::string& file);

}  // namespace abflat::test
