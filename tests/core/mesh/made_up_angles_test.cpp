#include <algorithm>
#include <cmath>
#include <vector>

#include "catch.h"
#include "mesh/triangle_geometry.h"

using namespace abflat;

TEST_CASE("a triangle without area is drawn with its corners in the same order", "[mesh]") {
  // Position of the third corner along the longest edge, and its distance from it, both relative to
  // the edge.
  const double places[][2] = {{0.5, 0},       {0.25, 1e-12}, {1 - 1e-6, 4e-10},
                              {1e-7, -1e-11}, {0, 0},        {1, 0}};
  for (const auto& [along, off] : places)
    for (std::uint32_t first = 0; first < 3; ++first)
      for (const double unit : {1e-6, 1.0, 1e6}) {
        std::vector<double> positions;
        for (const double x : {0.0, 0.0, 0.0, 1.0, 0.0, 0.0, along, off, 0.0})
          positions.push_back(unit * x);
        const TriangleVertices v{first, (first + 1) % 3, (first + 2) % 3};
        const auto alpha = anglesOrMadeUp(positions, v, cornerAngles(positions, v));
        CHECK(alpha[0] + alpha[1] + alpha[2] == Approx(kPi).epsilon(1e-14));
        CHECK(std::min({alpha[0], alpha[1], alpha[2]}) == Approx(kMadeUpAngle).epsilon(1e-3));
        // Edge lengths by the law of sines; the longest edge is opposite the third corner.
        const auto at = [&](std::uint32_t corner) {
          return std::sin(alpha[(corner + 3 - first) % 3]);
        };
        CHECK(at(1) / at(2) == Approx(along).margin(2 * kMadeUpAngle));
        CHECK(at(0) / at(2) == Approx(1 - along).margin(2 * kMadeUpAngle));
      }
}

TEST_CASE("a triangle that is a point is drawn as an equal one, and others as they are", "[mesh]") {
  const TriangleVertices v{0, 1, 2};
  const std::vector<double> point(9, 2.5);
  for (const double a : anglesOrMadeUp(point, v, cornerAngles(point, v))) CHECK(a == kPi / 3);
  const std::vector<double> needle = {0, 0, 0, 1, 0, 0, 0.3, 1e-6, 0};
  CHECK(anglesOrMadeUp(needle, v, cornerAngles(needle, v)) == cornerAngles(needle, v));
}
