#include "chart/disk_chart.h"

#include <algorithm>
#include <cmath>

#include "mesh/triangle_geometry.h"

namespace abflat {
namespace {

/// Power of two that brings the largest extent from the first vertex to about 1.
double unitOf(const PolygonMesh& mesh, const std::vector<std::uint32_t>& vertices) {
  double size = 0;
  for (std::uint32_t v : vertices)
    for (std::size_t d = 0; d < 3; ++d)
      size = std::max(
          size, std::abs(mesh.positions[3 * v + d] / 2 - mesh.positions[3 * vertices[0] + d] / 2));
  return size > 0 ? std::ldexp(1.0, std::ilogb(size) + 1) : 1;
}

}  // namespace

DiskChart makeDiskChart(const PolygonMesh& mesh, const Surface& surface) {
  DiskChart chart;
  const auto copy = [](const auto& ids, std::vector<std::uint32_t>& out) {
    out.assign(ids.begin(), ids.end());
  };
  copy(surface.fans.ofCorner, chart.vertexOfCorner);
  copy(surface.table.twin, chart.twin);
  copy(surface.boundaryLoops.front(), chart.boundary);
  copy(surface.fans.inputVertex, chart.inputVertex);
  placeChart(mesh, chart);
  return chart;
}

void placeChart(const PolygonMesh& mesh, DiskChart& chart) {
  chart.unit = unitOf(mesh, chart.inputVertex);
  chart.positions.clear();
  chart.positions.reserve(3 * chart.inputVertex.size());
  for (std::uint32_t v : chart.inputVertex)
    for (std::size_t d = 0; d < 3; ++d)
      chart.positions.push_back(mesh.positions[3 * v + d] / chart.unit);
  chart.angles.resize(chart.triangleCount());
  for (std::uint32_t f = 0; f < chart.triangleCount(); ++f)
    chart.angles[f] = cornerAngles(chart.positions, &chart.vertexOfCorner[3 * f]);
}

double surfaceArea(const DiskChart& chart) {
  double area = 0;
  for (std::uint32_t f = 0; f < chart.surfaceTriangles(); ++f) {
    const std::uint32_t* v = &chart.vertexOfCorner[3 * f];
    area += norm(cross(edgeVector(chart.positions, v[0], v[1]),
                       edgeVector(chart.positions, v[0], v[2]))) /
            2;
  }
  return area;
}

}  // namespace abflat
