#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "abflat/mesh.h"
#include "random_source.h"

namespace abflat::fuzz {

using Point = std::array<double, 3>;

/// A mesh in the making: faces by their vertices.
struct Shape {
  std::vector<Point> points;
  std::vector<std::vector<std::uint32_t>> faces;

  std::uint32_t add(const Point& p) {
    points.push_back(p);
    return static_cast<std::uint32_t>(points.size() - 1);
  }
  PolygonMesh mesh() const;
};

/// Squares over columns x rows, each cut in two where asked; sides may be joined to their opposite,
/// also the wrong way round.
struct Net {
  std::uint32_t columns = 4, rows = 4;
  bool isCut = true;  ///< triangles, not quads
  bool wrapsColumns = false, wrapsRows = false, isTwisted = false;
};
Shape net(const Net& net);

Shape bumpyNet(RandomSource& random);
Shape sphere(
    RandomSource& random);         ///< as three.js makes it: a doubled meridian, fans at the poles
Shape ring(RandomSource& random);  ///< torus, tube, cone, Moebius strip or Klein bottle
Shape box(RandomSource& random);   ///< sides apart or joined
Shape city(RandomSource& random);  ///< a plane with towers
Shape checkerboard(RandomSource& random);
Shape fan(RandomSource& random);  ///< of triangles, or a polygon of as many corners
Shape soup(RandomSource& random);
Shape tangle(RandomSource& random);   ///< any triangles over few vertices
Shape polygon(RandomSource& random);  ///< few faces of many corners, which may repeat

}  // namespace abflat::fuzz
