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

TEST_CASE("turns go round in equal steps, quarters exactly", "[pack]") {
  for (const PackShape& shape : test::makePackShapes("mixed", 30, 10, 5)) {
    const std::vector<PlanePoint> hull = convexHull(pointsOf(shape));
    const Pose base = leastBoxPose(hull);
    CHECK(Poses(base, 1, hull).size() == 1);
    for (const int count : {4, 16}) {
      const Poses poses(base, count, hull);
      REQUIRE(poses.size() == static_cast<std::size_t>(count));
      for (int k = 0; k < count; ++k) {
        const Pose pose = poses[static_cast<std::size_t>(k)];
        const Pose expected = turned(base, k, count, hull);
        CHECK(pose.cos == Approx(expected.cos).margin(1e-12));
        CHECK(pose.sin == Approx(expected.sin).margin(1e-12));
        CHECK(pose.minX == Approx(expected.minX).margin(1e-9));
        CHECK(pose.minY == Approx(expected.minY).margin(1e-9));
        CHECK(pose.width == Approx(expected.width).margin(1e-9));
        CHECK(pose.quarter == 4 * k / count);
        if (k < count / 4) continue;
        const Pose before = poses[static_cast<std::size_t>(k - count / 4)];
        CHECK((pose.cos == -before.sin && pose.sin == before.cos));
        CHECK((pose.width == before.height && pose.height == before.width));
      }
    }
  }
}
