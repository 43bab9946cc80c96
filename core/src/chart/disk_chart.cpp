#include "chart/disk_chart.h"

#include <algorithm>
#include <cmath>

#include "mesh/triangle_geometry.h"

namespace abflat {
namespace {

/// The power of two that scales the largest extent from the first vertex to about 1.
double unitOf(const PolygonMesh& mesh, const IdVector<ChartVertex, InputVertex>& vertices) {
  double size = 0;
  const InputVertex first = vertices.front();
  for (const InputVertex v : vertices)
    for (std::size_t d = 0; d < 3; ++d)
      size = std::max(size,
                      std::abs(mesh.positions[3 * v + d] / 2 - mesh.positions[3 * first + d] / 2));
  return size > 0 ? std::ldexp(1.0, std::ilogb(size) + 1) : 1;
}

/// If the chart is the whole surface, it has the same numbers.
template <class I, class Id, class Ids>
void copyAll(const Ids& from, IdVector<I, Id>& out) {
  out.reserve(from.size());
  for (const std::uint32_t number : from) out.push_back(Id(number));
}

}  // namespace

DiskChart makeDiskChart(const PolygonMesh& mesh, const Surface& surface) {
  DiskChart chart;
  copyAll(surface.fans.ofCorner, chart.vertexOfCorner);
  copyAll(surface.table.twin, chart.twin);
  copyAll(surface.boundaryLoops.front(), chart.boundary);
  copyAll(surface.fans.inputVertex, chart.inputVertex);
  placeChart(mesh, chart);
  return chart;
}

void placeChart(const PolygonMesh& mesh, DiskChart& chart) {
  chart.unit = unitOf(mesh, chart.inputVertex);
  chart.positions.resize(3 * chart.inputVertex.size());
  double* to = chart.positions.data();
  for (const InputVertex v : chart.inputVertex)
    for (std::size_t d = 0; d < 3; ++d) *to++ = mesh.positions[3 * v + d] / chart.unit;
  chart.angles.resize(chart.triangleCount());
  for (const ChartTriangle f : chart.triangles())
    chart.angles[f] = cornerAngles(chart.positions, verticesOf(chart.vertexOfCorner, f));
}

double surfaceArea(const DiskChart& chart) {
  double area = 0;
  for (const ChartTriangle f : chart.surfaceTriangles()) {
    const TriangleVertices v = verticesOf(chart.vertexOfCorner, f);
    area += norm(cross(edgeVector(chart.positions, v[0], v[1]),
                       edgeVector(chart.positions, v[0], v[2]))) /
            2;
  }
  return area;
}

}  // namespace abflat
