#include "samples/grid.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace abflat {

unsigned scaledCount(unsigned count, double detail) {
  return static_cast<unsigned>(std::lround(count * std::sqrt(std::max(detail, 1.0))));
}

std::uint32_t MeshBuilder::addPoint(const Point& p) {
  positions.insert(positions.end(), {p[0], p[2], -p[1]});
  return static_cast<std::uint32_t>(positions.size() / 3 - 1);
}

Point MeshBuilder::point(std::uint32_t v) const {
  return {positions[3 * v], -positions[3 * v + 2], positions[3 * v + 1]};
}

void MeshBuilder::addTriangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  indices.insert(indices.end(), {a, b, c});
}

PolygonMesh MeshBuilder::finish() {
  return makeTriangleMesh(std::move(positions), std::move(indices));
}

void joinRows(MeshBuilder& mesh, const std::vector<std::uint32_t>& outer,
              const std::vector<std::uint32_t>& inner) {
  const std::size_t n = outer.size() - 1, m = inner.size() - 1;
  std::size_t i = 0, j = 0;
  while (i < n || j < m) {
    // Advance along the row whose next edge has the earlier midpoint.
    if (j == m || (i < n && (2 * i + 1) * m <= (2 * j + 1) * n)) {
      mesh.addTriangle(outer[i], outer[i + 1], inner[j]);
      ++i;
    } else {
      mesh.addTriangle(outer[i], inner[j + 1], inner[j]);
      ++j;
    }
  }
}

PolygonMesh rectangleMesh(unsigned columns, unsigned rows,
                          const std::function<Point(double u, double v)>& at) {
  MeshBuilder mesh;
  for (unsigned r = 0; r <= rows; ++r)
    for (unsigned c = 0; c <= columns; ++c)
      mesh.addPoint(at(static_cast<double>(c) / columns, static_cast<double>(r) / rows));
  for (unsigned r = 0; r < rows; ++r)
    for (unsigned c = 0; c < columns; ++c) {
      const std::uint32_t a = r * (columns + 1) + c, b = a + 1, d = a + columns + 1, e = d + 1;
      if ((r + c) % 2 == 0) {
        mesh.addTriangle(a, b, e);
        mesh.addTriangle(a, e, d);
      } else {
        mesh.addTriangle(a, b, d);
        mesh.addTriangle(b, e, d);
      }
    }
  return mesh.finish();
}

PolygonMesh diskMesh(const RingDisk& disk) {
  MeshBuilder mesh;
  std::vector<std::uint32_t> inner{mesh.addPoint(disk.at(0, 0))};
  for (unsigned k = 1; k <= disk.rings; ++k) {
    const double r = static_cast<double>(k) / disk.rings;
    const unsigned count = std::max(3u, disk.ringSize(r)), points = count + (disk.isSlit ? 1 : 0);
    std::vector<std::uint32_t> outer;
    for (unsigned i = 0; i < points; ++i)
      outer.push_back(mesh.addPoint(disk.at(r, kSamplePi * (2.0 * i / count - 1))));
    if (!disk.isSlit) outer.push_back(outer.front());
    joinRows(mesh, outer, inner);
    inner.swap(outer);
  }
  return mesh.finish();
}

}  // namespace abflat
