#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "islands/island_triangles.h"

namespace abflat {

/// Triangles in their places, as the reader of a file gets them.
struct PlacedTriangles {
  std::vector<double> uv;            ///< 6 coordinates per triangle
  std::vector<std::uint32_t> face;   ///< per triangle, of the input
  std::vector<std::uint32_t> stack;  ///< per triangle; stacks may overlap themselves
};

/// Whether a box lies in one of so many tiles, ten in a row.
bool isInTile(const UvBox& box, std::uint32_t tiles);

/// What is wrong with a packed layout, decided exactly; empty if each stack lies in a tile and no
/// two overlap. `tiles`: how many there are, ten in a row.
std::string problemOf(const PlacedTriangles& placed, std::uint32_t tiles);

}  // namespace abflat
