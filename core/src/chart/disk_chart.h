#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "abflat/mesh.h"
#include "mesh/surface.h"

namespace abflat {

/// One topological disk, cut out of the mesh and ready to be flattened.
struct DiskChart {
  std::vector<std::uint32_t> vertexOfCorner;  ///< chart vertex per corner, size 3F
  std::vector<std::uint32_t> twin;            ///< opposite half-edge or kNone, size 3F
  std::vector<std::uint32_t>
      boundary;  ///< half-edges of the boundary loop in order, surface on the left
  std::vector<std::uint32_t> inputVertex;     ///< input vertex per chart vertex
  std::vector<double> positions;              ///< xyz per chart vertex, in `unit`
  std::vector<std::array<double, 3>> angles;  ///< per triangle in 3D, radians; see cornerAngles
  double unit = 1;                            ///< a power of two, so that scaling is exact
  /// Per chart vertex, its place in an elimination order that is good for the chart; empty where
  /// none is known.
  std::vector<std::uint32_t> place;

  std::uint32_t triangleCount() const {
    return static_cast<std::uint32_t>(vertexOfCorner.size() / 3);
  }
  std::uint32_t vertexCount() const { return static_cast<std::uint32_t>(inputVertex.size()); }
};

/// Area of the surface, in `unit` squared.
double surfaceArea(const DiskChart& chart);

/// The whole surface as one chart. Precondition: surface.summary.disk is Ok.
DiskChart makeDiskChart(const PolygonMesh& mesh, const Surface& surface);

/// Sets positions, angles and unit of a chart whose connectivity is complete.
void placeChart(const PolygonMesh& mesh, DiskChart& chart);

}  // namespace abflat
