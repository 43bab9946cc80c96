#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "abflat/atlas_size.h"
#include "abflat/mesh.h"
#include "islands/mapped_triangles.h"

namespace abflat {

constexpr double kNotMeasured = std::numeric_limits<double>::quiet_NaN();

/// What an island measures; lengths in uv are texels.
struct IslandMeasures {
  double area = 0;                ///< in uv, whichever way round triangles are
  double turning = 0;             ///< the same, negative for clockwise ones
  double onSurface = 0;           ///< area in 3D, in units of 4^exponent
  double width = 0;               ///< across the shorter side of its smallest box
  double density = kNotMeasured;  ///< texels per mesh unit
  double stretch = kNotMeasured;  ///< symmetric Dirichlet energy / 4 at its own scale

  bool isMirrored() const { return turning < 0; }
};

/// A number of a triangle, and which one it is.
struct AtTriangle {
  double value = kNotMeasured;
  std::uint32_t triangle = 0;
};

struct LayoutMeasures {
  std::vector<IslandMeasures> islands;
  std::vector<double> densityOf;         ///< per triangle; NaN without area on the surface
  std::vector<std::uint8_t> hasArea;     ///< per triangle: on the surface
  double density = kNotMeasured;         ///< texels per mesh unit, the mean by area
  AtTriangle leastDensity, mostDensity;  ///< of those with area in uv
  double stretch = kNotMeasured;         ///< mean by area
  double conformalMean = kNotMeasured, conformalMost = kNotMeasured;
};

LayoutMeasures measureIslands(const PolygonMesh& mesh, const MappedTriangles& triangles,
                              const AtlasSize& size);

}  // namespace abflat
