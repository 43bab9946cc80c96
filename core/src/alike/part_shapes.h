#pragma once

#include <cstdint>
#include <vector>

#include "alike/cells.h"
#include "mesh/triangle_geometry.h"

namespace abflat {

/// Measures of a part that do not change if it is moved, turned, mirrored or renumbered.
struct PartShape {
  std::uint64_t key = 0;  ///< how its polygons hang together
  std::uint32_t faces = 0;
  Vec3 centre{};
  double radius = 0;        ///< largest distance of a vertex from the centre
  double meanDistance = 0;  ///< from the centre, over all corners
  double meanEdge = 0;      ///< length
};

/// How far corresponding vertices may be apart, relative to the radius.
constexpr double kAlikeTolerance = 1e-3;

/// No mesh is symmetric across a plane with this normal.
constexpr Vec3 kNoAxis = {0.7548776662466927, 0.5698402909980532, 0.3247179572447461};

/// The shapes of all parts. Only those are measured that hang together like another one.
struct PartShapes {
  IdVector<PolygonFace, std::uint64_t> color;      ///< how the polygons around it hang together
  IdVector<PolygonCorner, std::uint32_t> valence;  ///< polygons of its part around its vertex
  std::vector<PolygonFace> faces;                  ///< part by part
  IdVector<PartId, std::uint32_t> begin;           ///< in `faces`; one more than there are parts
  IdVector<PartId, PartShape> part;

  IdSpan<std::size_t, PolygonFace> facesOf(PartId i) const {
    return {faces.data() + begin[i], begin[PartId(i + 1)] - begin[i]};
  }
  /// The same for corners that correspond to each other.
  std::uint64_t colorAt(PolygonFace f, PolygonCorner c) const { return color[f] + valence[c]; }
  /// Whether the measures allow two parts to be alike.
  bool mayBeAlike(PartId a, PartId b) const;
};

PartShapes shapesOf(const Cells& cells, const IdVector<PartId, std::uint8_t>& isLeftOut);

double distanceBetween(const double* a, const double* b);

}  // namespace abflat
