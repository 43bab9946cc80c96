#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "abflat/mesh.h"
#include "base/pulse.h"
#include "cut/ids.h"
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
  IdVector<SurfaceCorner, SurfaceVertex> vertexOfCorner;
  IdVector<SurfaceCorner, SurfaceCorner> twin;  ///< opposite half-edge, none on the boundary
  std::vector<double> positions;                ///< xyz per vertex, within the unit cube
  IdVector<SurfaceCorner, double> angle;        ///< radians; made up where degenerate
  IdVector<SurfaceTriangle, double> area;
  IdVector<SurfaceCorner, double> length;  ///< of a half-edge
  /// Of a seam along a half-edge: its length, less where it is hidden; kBarredCost where holes stay
  /// filled, infinite within a polygon.
  IdVector<SurfaceCorner, double> cost;
  IdVector<SurfaceCorner, double> weight;  ///< cotangent of the edge, positive; as that of its twin
  IdVector<SurfaceVertex, double> vertexArea;  ///< a third of the triangles' round it
  IdVector<SurfaceVertex, double> angleSum;
  /// That a triangle fills, none where it is of the surface; empty where no hole is filled. What
  /// fills comes last and has no area.
  IdVector<SurfaceTriangle, HoleId> hole;
  /// How many times as much as the log-scale tells flattening has stretched a triangle's chart;
  /// empty where nothing has been flattened.
  IdVector<SurfaceTriangle, double> excess;

  IdRange<SurfaceTriangle> triangles() const { return area.ids(); }
  IdRange<SurfaceCorner> corners() const { return twin.ids(); }
  IdRange<SurfaceVertex> vertices() const { return vertexArea.ids(); }
  std::uint32_t triangleCount() const { return static_cast<std::uint32_t>(area.size()); }
  std::uint32_t vertexCount() const { return static_cast<std::uint32_t>(vertexArea.size()); }
  double totalArea() const;
  /// Of the triangles that fill holes.
  IdRange<SurfaceCorner> fillingCorners() const;
  SurfaceVertex tail(SurfaceCorner h) const { return vertexOfCorner[h]; }
  SurfaceVertex head(SurfaceCorner h) const { return vertexOfCorner[nextCorner(h)]; }
  bool isFilling(SurfaceTriangle f) const { return !hole.empty() && hole[f].exists(); }
  /// A cut here can be seen: there is surface on both sides.
  bool isOnSurface(SurfaceCorner h) const {
    return !isFilling(triangleOf(h)) && twin[h].exists() && !isFilling(triangleOf(twin[h]));
  }
  /// Of the edge in the linear system of the scale: holes keep their shape.
  double stiffness(SurfaceCorner h) const {
    const SurfaceCorner o = twin[h];
    const bool isRim = o.exists() && isFilling(triangleOf(o)) && !isFilling(triangleOf(h));
    return isRim ? weight[h] + weight[o] : weight[h];
  }
};

/// Per vertex, how much a flattening scales there: lengths grow by e^u.
using LogScales = IdVector<SurfaceVertex, double>;

/// Per vertex, where its row comes in an elimination order: that of a mesh is good for any part of
/// it.
using EliminationRanks = IdVector<SurfaceVertex, std::uint32_t>;

/// `positions` are those of the input vertices that fans.inputVertex refers to, finite.
/// `isDiagonal` is empty where all faces are triangles. `scale` is per triangle
/// where several scales, which share no fan, have a grid each; or empty.
SeamMesh makeSeamMesh(const std::vector<double>& positions, const CornerTable& table,
                      const Fans& fans,
                      const IdVector<SurfaceCorner, std::uint8_t>& isDiagonal = {},
                      const IdVector<SurfaceTriangle, std::uint8_t>& scale = {},
                      const Pulse& pulse = {});

}  // namespace abflat
