#include <cmath>
#include <vector>

#include "abflat/unwrap.h"
#include "base/constants.h"
#include "catch.h"
#include "support/meshes.h"
#include "support/unwrapped.h"

using namespace abflat;
using namespace abflat::test;

namespace {

std::vector<ChartShape> shapes(const PolygonMesh& mesh) {
  UnwrapOptions options;
  options.packingCuts = PackingCuts::Never;
  std::vector<ChartShape> out;
  for (const UnwrapChart& chart : unwrapped(mesh, options).report.charts)
    out.push_back(chart.shape);
  return out;
}

PolygonMesh sheet(double width, double height) {
  return makeTriangleMesh({0, 0, 0, width, 0, 0, width, height, 0, 0, height, 0},
                          {0, 1, 2, 0, 2, 3});
}

/// Between two circles.
PolygonMesh ring(unsigned sides, double inner) {
  std::vector<double> positions;
  std::vector<std::uint32_t> triangles;
  for (unsigned i = 0; i < sides; ++i)
    for (const double r : {1.0, inner}) {
      const double angle = 2 * kPi * i / sides;
      positions.insert(positions.end(), {r * std::cos(angle), r * std::sin(angle), 0});
      const unsigned a = 2 * i, b = 2 * ((i + 1) % sides);
      if (r == 1.0)
        triangles.insert(triangles.end(), {a, b, a + 1});
      else
        triangles.insert(triangles.end(), {b, b + 1, a + 1});
    }
  return makeTriangleMesh(std::move(positions), std::move(triangles));
}

}  // namespace

TEST_CASE("charts are named by what they look like", "[unwrap]") {
  using Shapes = std::vector<ChartShape>;
  CHECK(shapes(cylinder(32, 4)) == Shapes{ChartShape::Rectangle});
  CHECK(shapes(sheet(1, 1)) == Shapes{ChartShape::Rectangle});
  CHECK(shapes(sheet(5, 1)) == Shapes{ChartShape::Strip});
  CHECK(shapes(cone(48, 0)) == Shapes{ChartShape::Disc});
  CHECK(shapes(cone(6, 0)) == Shapes{ChartShape::Other});
  CHECK(shapes(ring(32, 0.5)) == Shapes{ChartShape::Ring});
  CHECK(shapes(star(7)) == Shapes{ChartShape::Other});
}

TEST_CASE("the report says whether seams are symmetric", "[unwrap]") {
  UnwrapOptions options;
  CHECK_FALSE(unwrapped(bumpyGrid(12, 9, 1, 3), options).report.seams.symmetric);
  const PolygonMesh mesh = sharedMesh("spot-uv.obj");
  if (mesh.faceCount() == 0) return;
  CHECK(unwrapped(mesh, options).report.seams.symmetric);
  options.symmetricSeams = SymmetricSeams::Never;
  CHECK_FALSE(unwrapped(mesh, options).report.seams.symmetric);
}
