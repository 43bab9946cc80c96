#include "samples/grid.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace abflat {

unsigned scaledCount(unsigned count, double detail) {
  return static_cast<unsigned>(std::lround(count * std::sqrt(std::max(detail, 1.0))));
}

std::uint32_t MeshBuilder::addPoint(const Point& p) {
  positions.insert(positions.end(), p.begin(), p.end());
  return static_cast<std::uint32_t>(positions.size() / 3 - 1);
}

void MeshBuilder::addTriangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  indices.insert(indices.end(), {a, b, c});
}

PolygonMesh MeshBuilder::finish() {
  return makeTriangleMesh(std::move(positions), std::move(indices));
}

void joinRings(MeshBuilder& mesh, const std::vector<std::uint32_t>& outer,
               const std::vector<std::uint32_t>& inner) {
  const std::size_t n = outer.size(), m = inner.size();
  std::size_t i = 0, j = 0;
  while (i < n || j < m) {
    const std::uint32_t a = outer[i % n], b = inner[j % m];
    // Go on along the ring whose next edge has its middle first.
    if (j >= m || (i < n && (2 * i + 1) * m <= (2 * j + 1) * n)) {
      ++i;
      mesh.addTriangle(a, outer[i % n], b);
    } else {
      ++j;
      mesh.addTriangle(a, inner[j % m], b);
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

PolygonMesh diskMesh(unsigned rings, const std::function<Point(double r, double phi)>& at) {
  MeshBuilder mesh;
  std::vector<std::uint32_t> inner{mesh.addPoint(at(0, 0))}, outer;
  for (unsigned k = 1; k <= rings; ++k) {
    outer.clear();
    for (unsigned i = 0; i < 6 * k; ++i)
      outer.push_back(
          mesh.addPoint(at(static_cast<double>(k) / rings, 2 * kSamplePi * i / (6 * k))));
    if (k == 1)
      for (unsigned i = 0; i < 6; ++i) mesh.addTriangle(inner[0], outer[i], outer[(i + 1) % 6]);
    else
      joinRings(mesh, outer, inner);
    inner.swap(outer);
  }
  return mesh.finish();
}

}  // namespace abflat
