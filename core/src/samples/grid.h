#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "abflat/mesh.h"

namespace abflat {

/// xyz as the generators use it: z up, the front towards -y. Meshes have y up and the front towards
/// +z, as OBJ viewers show them.
using Point = std::array<double, 3>;

constexpr double kSamplePi = 3.14159265358979323846;

/// The count for a detail at which it is `count` for detail 1, chosen so that the product of two
/// such counts, and with it the number of faces, is linear in detail.
unsigned scaledCount(unsigned count, double detail);

/// Mesh under construction.
struct MeshBuilder {
  std::vector<double> positions;  ///< y up
  std::vector<std::uint32_t> indices;

  std::uint32_t addPoint(const Point& p);
  Point point(std::uint32_t v) const;
  void addTriangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);
  PolygonMesh finish();
};

/// Joins two rows of vertices by a band of triangles, `inner` to the left of `outer`; they may have
/// different sizes.
void joinRows(MeshBuilder& mesh, const std::vector<std::uint32_t>& outer,
              const std::vector<std::uint32_t>& inner);

/// columns x rows squares over [0,1]^2, each cut in two along alternating diagonals.
PolygonMesh rectangleMesh(unsigned columns, unsigned rows,
                          const std::function<Point(double u, double v)>& at);

/// Unit disk made of a centre and rings around it, mapped to space.
struct RingDisk {
  unsigned rings = 1;                             ///< at equal distances
  std::function<unsigned(double r)> ringSize;     ///< edges of the ring of radius r in (0,1]
  std::function<Point(double r, double phi)> at;  ///< phi in [-pi, pi]
  bool isSlit = false;                            ///< cut open from the centre along phi = pi
};
PolygonMesh diskMesh(const RingDisk& disk);

}  // namespace abflat
