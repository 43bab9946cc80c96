#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "abflat/generated/unwrap_options.h"
#include "abflat/mesh.h"
#include "base/listener.h"
#include "cut/ids.h"
#include "mesh/corner_table.h"
#include "mesh/topology.h"

namespace abflat {

/// Cost of a seam that is made only if nothing else makes a chart a disk. It exceeds that of any
/// path without such a seam, since lengths are within the unit cube. Finite, so that paths reach
/// every vertex.
constexpr double kBarredCost = 1e9;

/// What a seam in the front costs, relative to elsewhere.
constexpr double kDearInFront = 3;

/// What ends along a half-edge: shading, or a material.
constexpr std::uint8_t kHardEdge = 1, kMaterialBorder = 2;

/// The input of the seam finder: an oriented manifold surface with any number of components, and
/// its geometry. Vertices are fans, so each is either interior or passed by the boundary once.
/// What is measured is rounded, so that no result depends on the mesh's unit, or on how it lies.
/// Coordinates are not: what compares distances has to round them.
struct SeamMesh {
  IdVector<SurfaceCorner, SurfaceVertex> vertexOfCorner;
  IdVector<SurfaceCorner, SurfaceCorner> twin;  ///< opposite half-edge, none on the boundary
  std::vector<double> positions;                ///< xyz per vertex, within the unit cube
  IdVector<SurfaceCorner, double> angle;        ///< radians; made up for degenerate triangles
  IdVector<SurfaceTriangle, double> area;
  IdVector<SurfaceCorner, double> length;  ///< of a half-edge
  /// Cost of a seam along a half-edge: its length, less where it is hidden, more in flat faces and
  /// where people look.
  /// kBarredCost where holes have to stay filled, infinite within a polygon.
  IdVector<SurfaceCorner, double> cost;
  /// By how much cost is higher than it would be elsewhere; empty: 1. Edges of triangles that fill
  /// holes may be missing.
  IdVector<SurfaceCorner, double> dearness;
  IdVector<SurfaceCorner, double> weight;  ///< cotangent of the edge, positive; equal to its twin's
  IdVector<SurfaceVertex, double> vertexArea;  ///< a third of the area of the triangles around it
  IdVector<SurfaceVertex, double> angleSum;
  /// The hole that a triangle fills, none if it is part of the surface; empty if no hole is filled.
  /// Triangles that fill holes come last and have no area.
  IdVector<SurfaceTriangle, HoleId> hole;
  /// Where stretch is better than a seam: how far each triangle is in the front of a figure, from 0
  /// to 1. Empty: nowhere. Triangles that fill holes may be missing.
  IdVector<SurfaceTriangle, double> front;
  double frontLeeway = 1;  ///< by how much less stretch counts there
  /// The ratio by which flattening stretched a triangle's chart more than the log-scale predicts;
  /// empty if nothing has been flattened.
  IdVector<SurfaceTriangle, double> excess;

  IdRange<SurfaceTriangle> triangles() const { return area.ids(); }
  IdRange<SurfaceCorner> corners() const { return twin.ids(); }
  IdRange<SurfaceVertex> vertices() const { return vertexArea.ids(); }
  std::uint32_t triangleCount() const { return static_cast<std::uint32_t>(area.size()); }
  std::uint32_t vertexCount() const { return static_cast<std::uint32_t>(vertexArea.size()); }
  double totalArea() const;
  /// The corners of triangles that fill holes.
  IdRange<SurfaceCorner> fillingCorners() const;
  SurfaceVertex tail(SurfaceCorner h) const { return vertexOfCorner[h]; }
  SurfaceVertex head(SurfaceCorner h) const { return vertexOfCorner[nextCorner(h)]; }
  double dearnessAt(SurfaceCorner h) const { return h < dearness.size() ? dearness[h] : 1; }
  double frontAt(SurfaceTriangle f) const { return f < front.size() ? front[f] : 0; }
  double leewayAt(SurfaceTriangle f) const { return 1 + (frontLeeway - 1) * frontAt(f); }
  /// What a seam would cost if people looked elsewhere; more than its length in a flat face.
  double plainCost(SurfaceCorner h) const { return cost[h] / dearnessAt(h); }
  bool isFilling(SurfaceTriangle f) const { return !hole.empty() && hole[f].exists(); }
  /// Whether a cut here can be seen, which takes surface on both sides.
  bool isOnSurface(SurfaceCorner h) const {
    return !isFilling(triangleOf(h)) && twin[h].exists() && !isFilling(triangleOf(twin[h]));
  }
  /// The edge's entry in the linear system of the scale. Holes keep their shape.
  double stiffness(SurfaceCorner h) const {
    const SurfaceCorner o = twin[h];
    const bool isRim = o.exists() && isFilling(triangleOf(o)) && !isFilling(triangleOf(h));
    return isRim ? weight[h] + weight[o] : weight[h];
  }
};

/// Per vertex, the log of the scale of a flattening there: lengths grow by e^u.
using LogScales = IdVector<SurfaceVertex, double>;

/// The rank of each vertex in an elimination order. The ranks of a mesh also suit any part of it.
using EliminationRanks = IdVector<SurfaceVertex, std::uint32_t>;

/// `positions` are those of the input vertices that fans.inputVertex refers to, finite.
/// `isDiagonal` is empty if all faces are triangles. `scale` is given per triangle if there are
/// several scales, which share no fan and have a grid each; otherwise it is empty. `breaks`:
/// kHardEdge and kMaterialBorder, as far as the file has them; empty if it has neither, and edges
/// of triangles that fill holes may be missing. `upAxis`: the coordinate that points up.
SeamMesh makeSeamMesh(const std::vector<double>& positions, const CornerTable& table,
                      const Fans& fans,
                      const IdVector<SurfaceCorner, std::uint8_t>& isDiagonal = {},
                      const IdVector<SurfaceTriangle, std::uint8_t>& scale = {},
                      const IdVector<SurfaceCorner, std::uint8_t>& breaks = {},
                      SeamCosts costs = SeamCosts::Sight, std::size_t upAxis = 1,
                      const Listener& listener = {});

}  // namespace abflat
