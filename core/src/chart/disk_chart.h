#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "abflat/mesh.h"
#include "mesh/ids.h"
#include "mesh/surface.h"

namespace abflat {

/// One topological disk, cut out of the mesh and ready to be flattened.
struct DiskChart {
  IdVector<ChartCorner, ChartVertex> vertexOfCorner;
  IdVector<ChartCorner, ChartCorner> twin;  ///< opposite half-edge, none on the boundary
  /// Half-edges of the boundary loop in order, with the surface on their left.
  IdVector<BoundaryIndex, ChartCorner> boundary;
  IdVector<ChartVertex, InputVertex> inputVertex;
  std::vector<double> positions;                          ///< xyz per vertex, in `unit`
  IdVector<ChartTriangle, std::array<double, 3>> angles;  ///< in 3D, radians; see cornerAngles
  double unit = 1;  ///< a power of two, so that scaling is exact
  /// The elimination rank of each vertex, in an order that suits the chart; empty if unknown.
  IdVector<ChartVertex, std::uint32_t> eliminationRank;
  /// The last triangles fill holes: they are flattened with the others, but no measure counts them.
  std::uint32_t fillingTriangles = 0;
  std::uint32_t filledHoles = 0;

  std::uint32_t triangleCount() const {
    return static_cast<std::uint32_t>(vertexOfCorner.size() / 3);
  }
  std::uint32_t vertexCount() const { return static_cast<std::uint32_t>(inputVertex.size()); }
  IdRange<ChartTriangle> triangles() const { return IdRange<ChartTriangle>(triangleCount()); }
  IdRange<ChartCorner> corners() const { return vertexOfCorner.ids(); }
  IdRange<ChartVertex> vertices() const { return inputVertex.ids(); }

  /// Excludes triangles that fill holes.
  IdRange<ChartTriangle> surfaceTriangles() const {
    return IdRange<ChartTriangle>(triangleCount() - fillingTriangles);
  }
  IdRange<ChartCorner> surfaceCorners() const {
    return IdRange<ChartCorner>(3 * surfaceTriangles().size());
  }

  /// The vertex that a boundary half-edge leaves.
  ChartVertex boundaryVertex(BoundaryIndex i) const { return vertexOfCorner[boundary[i]]; }
  /// Neighbours around the loop.
  BoundaryIndex before(BoundaryIndex i) const {
    return BoundaryIndex((i == 0 ? boundary.size() : i) - 1);
  }
  BoundaryIndex after(BoundaryIndex i) const {
    return BoundaryIndex(i + 1 == boundary.size() ? 0 : i + 1);
  }
};

/// Per boundary vertex, the largest interior angle that is allowed, in units of pi.
using BoundaryBounds = IdVector<BoundaryIndex, double>;

/// Per boundary vertex: 1 if the layout's boundary goes straight on there, with an angle of exactly
/// pi. Empty: nowhere.
using StraightPlaces = IdVector<BoundaryIndex, std::uint8_t>;

/// Area of the surface without hole fillings, in `unit` squared.
double surfaceArea(const DiskChart& chart);

/// The whole surface as one chart. Precondition: surface.summary.disk is Ok.
DiskChart makeDiskChart(const PolygonMesh& mesh, const Surface& surface);

/// Sets positions, angles and unit of a chart whose connectivity is complete.
void placeChart(const PolygonMesh& mesh, DiskChart& chart);

}  // namespace abflat
