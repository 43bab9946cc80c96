#include "pack/pose.h"

#include <cmath>
#include <random>

#include "catch.h"
#include "pack/shapes.h"

using namespace abflat;

namespace {

std::vector<PlanePoint> pointsOf(const PackShape& shape) {
  std::vector<PlanePoint> out;
  for (std::size_t i = 0; i < shape.uv.size(); i += 2)
    out.push_back({shape.uv[i], shape.uv[i + 1]});
  return out;
}

}  // namespace

TEST_CASE("the hull is convex and contains all points", "[pack]") {
  for (const PackShape& shape : test::makePackShapes("mixed", 100, 10, 9)) {
    const std::vector<PlanePoint> points = pointsOf(shape), hull = convexHull(points);
    REQUIRE(hull.size() >= 3);
    for (std::size_t i = 0; i < hull.size(); ++i) {
      const PlanePoint a = hull[i], b = hull[(i + 1) % hull.size()];
      for (const PlanePoint& p : points)
        CHECK((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x) > -1e-14);
    }
  }
  CHECK(convexHull({}).empty());
  CHECK(convexHull({{1, 2}, {1, 2}}).size() == 1);
  CHECK(convexHull({{1, 2}, {3, 3}, {2, 2.5}}).size() == 2);
}

TEST_CASE("no rotation has a smaller box than the least", "[pack]") {
  for (const PackShape& shape : test::makePackShapes("mixed", 100, 10, 4)) {
    const std::vector<PlanePoint> hull = convexHull(pointsOf(shape));
    const Pose least = leastBoxPose(hull);
    CHECK(least.width >= least.height * (1 - 1e-8));
    CHECK(least.cos * least.cos + least.sin * least.sin == Approx(1).epsilon(1e-14));
    for (int k = 0; k < 720; ++k) {
      const Pose pose = turned({}, k, 720, hull);
      CHECK(pose.width * pose.height >= least.width * least.height * (1 - 1e-8));
    }
  }
}

TEST_CASE("quarter turns swap the sides exactly", "[pack]") {
  for (const PackShape& shape : test::makePackShapes("stars", 20, 10, 4)) {
    const std::vector<PlanePoint> hull = convexHull(pointsOf(shape));
    const Pose base = leastBoxPose(hull);
    for (const int of : {4, 8, 64})
      for (int quarter = 0; quarter < 4; ++quarter) {
        const Pose pose = turned(base, quarter * of / 4, of, hull);
        CHECK(pose.width == (quarter % 2 ? base.height : base.width));
        CHECK(pose.height == (quarter % 2 ? base.width : base.height));
      }
  }
}
