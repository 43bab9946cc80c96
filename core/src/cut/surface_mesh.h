#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "abflat/mesh.h"
#include "base/pulse.h"
#include "mesh/corner_table.h"
#include "mesh/topology.h"

namespace abflat {

/// Cost of a seam that is made only where nothing else makes a chart a disk: above that of any path
/// without one, since lengths are within the unit cube. Finite, so that paths reach every vertex.
constexpr double kBarredCost = 1e9;

/// What the seam finder works on: an oriented manifold surface, of any number of components, and
/// its geometry. Vertices are fans, so each is either interior or passed by the boundary once.
/// Coordinates are rounded to a grid over the mesh's own extent: no result depends on its unit or
/// place.
struct SeamMesh {
  std::vector<std::uint32_t> vertexOfCorner;  ///< fan per corner, size 3F
  std::vector<std::uint32_t> twin;            ///< opposite half-edge, kNone on the boundary
  std::vector<double> positions;              ///< xyz per fan, within the unit cube
  std::vector<double> angle;                  ///< per corner, radians; made up where degenerate
  std::vector<double> area;                   ///< per triangle
  std::vector<double> length;                 ///< per half-edge
  /// Of a seam per half-edge: its length, less where it is hidden; kBarredCost where holes stay
  /// filled, infinite within a polygon.
  std::vector<double> cost;
  std::vector<double> weight;      ///< cotangent weight of the edge, positive; the same for twins
  std::vector<double> vertexArea;  ///< a third of the triangles' round it
  std::vector<double> angleSum;    ///< per fan
  /// Per triangle the hole that it fills, kNone where it is of the surface; empty where no hole is
  /// filled. What fills comes last and has no area.
  std::vector<std::uint32_t> hole;
  /// Per triangle how many times as much as the log-scale tells flattening has stretched its chart;
  /// empty where nothing has been flattened.
  std::vector<double> excess;

  std::uint32_t triangleCount() const { return static_cast<std::uint32_t>(area.size()); }
  std::uint32_t vertexCount() const { return static_cast<std::uint32_t>(vertexArea.size()); }
  double totalArea() const;
  bool isFilling(std::uint32_t triangle) const { return !hole.empty() && hole[triangle] != kNone; }
  /// A cut here can be seen: there is surface on both sides.
  bool isOnSurface(std::uint32_t h) const {
    return !isFilling(h / 3) && twin[h] != kNone && !isFilling(twin[h] / 3);
  }
  /// Of the edge in the linear system of the scale: holes keep their shape.
  double stiffness(std::uint32_t h) const {
    const std::uint32_t o = twin[h];
    const bool isRim = o != kNone && isFilling(o / 3) && !isFilling(h / 3);
    return isRim ? weight[h] + weight[o] : weight[h];
  }
};

/// `positions` are those of the input vertices that fans.inputVertex refers to, finite.
/// `isDiagonal` is per half-edge, or empty where all faces are triangles. `scale` is per triangle
/// where several scales, which share no fan, have a grid each; or empty.
SeamMesh makeSeamMesh(const std::vector<double>& positions, const CornerTable& table,
                      const Fans& fans,
                      const IdVector<SurfaceCorner, std::uint8_t>& isDiagonal = {},
                      const IdVector<SurfaceTriangle, std::uint8_t>& scale = {},
                      const Pulse& pulse = {});

}  // namespace abflat
