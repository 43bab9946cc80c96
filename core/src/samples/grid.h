#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "abflat/mesh.h"

namespace abflat {

using Point = std::array<double, 3>;

constexpr double kSamplePi = 3.14159265358979323846;

/// `count` at detail 1, so that counts in two directions multiply to faces linear in detail.
unsigned scaledCount(unsigned count, double detail);

/// Mesh under construction.
struct MeshBuilder {
  std::vector<double> positions;
  std::vector<std::uint32_t> indices;

  std::uint32_t addPoint(const Point& p);
  void addTriangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);
  PolygonMesh finish();
};

/// Joins two closed rings of vertices, both counter-clockwise with `inner` to the left of `outer`,
/// by a band of triangles; the rings may have different sizes.
void joinRings(MeshBuilder& mesh, const std::vector<std::uint32_t>& outer,
               const std::vector<std::uint32_t>& inner);

/// columns x rows squares over [0,1]^2, each cut in two, the cuts alternating.
PolygonMesh rectangleMesh(unsigned columns, unsigned rows,
                          const std::function<Point(double u, double v)>& at);

/// Unit disk of near equilateral triangles: a centre and `rings` rings of 6, 12, 18, ... vertices
/// at radius r in (0,1], 6 rings^2 faces. `at` maps polar coordinates to space.
PolygonMesh diskMesh(unsigned rings, const std::function<Point(double r, double phi)>& at);

}  // namespace abflat
