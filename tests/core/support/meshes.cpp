#include "support/meshes.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>
#include <iterator>
#include <numeric>

#include "abflat/io.h"
#include "base/constants.h"
#include "mesh/triangle_geometry.h"

namespace abflat::test {
namespace {

/// Two triangles per square of a grid of vertices that may wrap around.
std::vector<std::uint32_t> gridTriangles(unsigned columns, unsigned rows, unsigned vertexColumns,
                                         unsigned vertexRows) {
  std::vector<std::uint32_t> t;
  for (unsigned j = 0; j < rows; ++j)
    for (unsigned i = 0; i < columns; ++i) {
      const auto at = [&](unsigned x, unsigned y) {
        return (y % vertexRows) * vertexColumns + x % vertexColumns;
      };
      const std::uint32_t a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
      t.insert(t.end(), {a, b, c, a, c, d});
    }
  return t;
}

}  // namespace

PolygonMesh bumpyGrid(unsigned columns, unsigned rows, double height, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> jitter(-0.25, 0.25), bump(-height, height);
  std::vector<double> p;
  for (unsigned j = 0; j <= rows; ++j)
    for (unsigned i = 0; i <= columns; ++i)
      p.insert(p.end(), {i + jitter(random), j + jitter(random), bump(random)});
  return makeTriangleMesh(p, gridTriangles(columns, rows, columns + 1, rows + 1));
}

PolygonMesh torus(unsigned columns, unsigned rows) {
  std::vector<double> p;
  for (unsigned j = 0; j < rows; ++j)
    for (unsigned i = 0; i < columns; ++i) {
      const double u = 2 * kPi * i / columns, v = 2 * kPi * j / rows, r = 2 + std::cos(v);
      p.insert(p.end(), {r * std::cos(u), r * std::sin(u), std::sin(v)});
    }
  return makeTriangleMesh(p, gridTriangles(columns, rows, columns, rows));
}

PolygonMesh cylinder(unsigned columns, unsigned rows) {
  std::vector<double> p;
  for (unsigned j = 0; j <= rows; ++j)
    for (unsigned i = 0; i < columns; ++i) {
      const double u = 2 * kPi * i / columns;
      p.insert(p.end(), {std::cos(u), std::sin(u), double(j)});
    }
  return makeTriangleMesh(p, gridTriangles(columns, rows, columns, rows + 1));
}

PolygonMesh uvSphere(unsigned columns, unsigned rows) {
  PolygonMesh mesh;
  for (unsigned j = 0; j <= rows; ++j)
    for (unsigned i = 0; i <= columns; ++i) {
      const double u = 2 * kPi * i / columns, v = kPi * j / rows;
      for (const double x : {-std::cos(u) * std::sin(v), std::cos(v), std::sin(u) * std::sin(v)})
        mesh.positions.push_back(static_cast<float>(x));
    }
  mesh.faceOffsets.push_back(0);
  const auto face = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    mesh.faceVertices.insert(mesh.faceVertices.end(), {a, b, c});
    mesh.faceOffsets.push_back(static_cast<std::uint32_t>(mesh.faceVertices.size()));
  };
  for (unsigned j = 0; j < rows; ++j)
    for (unsigned i = 0; i < columns; ++i) {
      const std::uint32_t a = j * (columns + 1) + i + 1, b = a - 1, c = b + columns + 1,
                          d = a + columns + 1;
      if (j > 0) face(a, b, d);
      if (j + 1 < rows) face(b, c, d);
    }
  return mesh;
}

PolygonMesh dentedBall(const std::array<double, 3>& toward) {
  PolygonMesh mesh = uvSphere(64, 40);
  const Vec3 aside = std::abs(toward[0]) < 0.9 ? Vec3{1, 0, 0} : Vec3{0, 0, 1};
  const Vec3 across = cross(toward, aside);
  for (const double turn : {0.0, 1.25, 2.5, 3.75, 5.0}) {
    const Vec3 other = cross(toward, across);
    Vec3 at{};
    for (std::size_t d = 0; d < 3; ++d)
      at[d] = toward[d] + 0.7 * (std::cos(turn) * across[d] + std::sin(turn) * other[d]);
    for (std::size_t i = 0; i < mesh.positions.size(); i += 3) {
      double* const p = &mesh.positions[i];
      const double angle = angleBetween({p[0], p[1], p[2]}, at);
      const double deep = 0.35 * std::exp(-angle * angle / 0.04);
      for (std::size_t d = 0; d < 3; ++d) p[d] *= 1 - deep;
    }
  }
  return mesh;
}

PolygonMesh tetrahedron() {
  return makeTriangleMesh({1, 1, 1, -1, -1, 1, -1, 1, -1, 1, -1, -1},
                          {0, 1, 3, 0, 2, 1, 0, 3, 2, 1, 2, 3});
}

PolygonMesh cone(unsigned n, double height) {
  std::vector<double> p{0, 0, height};
  std::vector<std::uint32_t> t;
  for (unsigned i = 0; i < n; ++i) {
    p.insert(p.end(), {std::cos(2 * kPi * i / n), std::sin(2 * kPi * i / n), 0});
    t.insert(t.end(), {0, 1 + i, 1 + (i + 1) % n});
  }
  return makeTriangleMesh(p, t);
}

PolygonMesh star(unsigned n) {
  PolygonMesh mesh;
  mesh.faceOffsets = {0, 2 * n};
  for (unsigned i = 0; i < 2 * n; ++i) {
    const double r = i % 2 ? 0.4 : 1, u = kPi * i / n;
    mesh.positions.insert(mesh.positions.end(), {r * std::cos(u), 0, -r * std::sin(u)});
    mesh.faceVertices.push_back(i);
  }
  return mesh;
}

PolygonMesh transformed(const PolygonMesh& mesh, double scale, const std::array<double, 3>& shift) {
  // Rotations about z by 1 and about x by 2 radians.
  const double c1 = std::cos(1), s1 = std::sin(1), c2 = std::cos(2), s2 = std::sin(2);
  PolygonMesh out = mesh;
  for (std::size_t v = 0; v < mesh.vertexCount(); ++v) {
    const double *p = &mesh.positions[3 * v], x = c1 * p[0] - s1 * p[1], y = s1 * p[0] + c1 * p[1];
    out.positions[3 * v] = scale * x + shift[0];
    out.positions[3 * v + 1] = scale * (c2 * y - s2 * p[2]) + shift[1];
    out.positions[3 * v + 2] = scale * (s2 * y + c2 * p[2]) + shift[2];
  }
  return out;
}

Renumbered renumbered(const PolygonMesh& mesh, unsigned seed) {
  std::mt19937 random(seed);
  Renumbered out;
  out.vertex.resize(mesh.vertexCount());
  std::iota(out.vertex.begin(), out.vertex.end(), 0u);
  std::shuffle(out.vertex.begin(), out.vertex.end(), random);
  out.mesh.positions.resize(mesh.positions.size());
  for (std::size_t v = 0; v < mesh.vertexCount(); ++v)
    for (std::size_t d = 0; d < 3; ++d)
      out.mesh.positions[3 * out.vertex[v] + d] = mesh.positions[3 * v + d];
  std::vector<std::uint32_t> faces(mesh.faceCount());
  std::iota(faces.begin(), faces.end(), 0u);
  std::shuffle(faces.begin(), faces.end(), random);
  out.corner.resize(mesh.faceVertices.size());
  out.mesh.faceOffsets = {0};
  for (const std::uint32_t f : faces) {
    const std::uint32_t begin = mesh.faceOffsets[f], n = mesh.faceOffsets[f + 1] - begin;
    const auto first = static_cast<std::uint32_t>(random() % n);
    for (std::uint32_t k = 0; k < n; ++k) {
      const std::uint32_t c = begin + (first + k) % n;
      out.corner[c] = static_cast<std::uint32_t>(out.mesh.faceVertices.size());
      out.mesh.faceVertices.push_back(out.vertex[mesh.faceVertices[c]]);
    }
    out.mesh.faceOffsets.push_back(static_cast<std::uint32_t>(out.mesh.faceVertices.size()));
  }
  return out;
}

PolygonMesh exploded(const PolygonMesh& mesh) {
  PolygonMesh out;
  out.faceOffsets = mesh.faceOffsets;
  for (const std::size_t v : mesh.faceVertices) {
    out.faceVertices.push_back(static_cast<std::uint32_t>(out.faceVertices.size()));
    out.positions.insert(out.positions.end(), &mesh.positions[3 * v], &mesh.positions[3 * v] + 3);
  }
  return out;
}

PolygonMesh sharedMesh(const std::string& file) {
  const std::string path = std::string(ABFLAT_SHARED_DIR) + "/meshes/" + file;
  std::ifstream in(path, std::ios::binary);
  if (!in) {
    std::cerr << "skipped: " << file << " is not beside the project\n";
    return {};
  }
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  const Result<MeshFormat> format = detectFormat(path, bytes);
  const Result<PolygonMesh> mesh =
      format.ok() ? readMesh(bytes, format.value(), path) : format.status();
  if (!mesh.ok()) throw std::runtime_error(mesh.status().message);
  return mesh.value();
}

}  // namespace abflat::test
