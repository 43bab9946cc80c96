#include "pack/level_pose.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "catch.h"
#include "pack/shapes.h"

using namespace abflat;

namespace {

constexpr double kPi = 3.14159265358979323846;

using Outline = std::vector<PlanePoint>;

PlanePoint turnedBy(double angle, PlanePoint p) {
  return {std::cos(angle) * p.x - std::sin(angle) * p.y,
          std::sin(angle) * p.x + std::cos(angle) * p.y};
}

Outline turnedBy(double angle, Outline outline) {
  for (PlanePoint& p : outline) p = turnedBy(angle, p);
  return outline;
}

LevelPose levelOf(const Outline& outline, PlanePoint up) {
  Loops loops;
  loops.points = outline;
  loops.ends = {static_cast<std::uint32_t>(outline.size())};
  loops.isGroup = {1};
  return levelPose(loops, convexHull(outline), up);
}

/// A box, each side in as many pieces of random length.
Outline box(double width, double height, unsigned pieces, std::mt19937& random) {
  const PlanePoint corners[] = {{0, 0}, {width, 0}, {width, height}, {0, height}};
  std::uniform_real_distribution<double> share(0, 1);
  Outline out;
  for (int k = 0; k < 4; ++k) {
    const PlanePoint a = corners[k], b = corners[(k + 1) % 4];
    std::vector<double> places(pieces);
    places[0] = 0;
    for (unsigned i = 1; i < pieces; ++i) places[i] = share(random);
    std::sort(places.begin(), places.end());
    for (const double s : places) out.push_back({a.x + s * (b.x - a.x), a.y + s * (b.y - a.y)});
  }
  return out;
}

Outline disc(unsigned corners) {
  Outline out;
  for (unsigned k = 0; k < corners; ++k) out.push_back(turnedBy(2 * kPi * k / corners, {1, 0}));
  return out;
}

/// How far edges are from lying along u or v: the largest sine.
double skewness(const Outline& outline, const Pose& pose) {
  double worst = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const PlanePoint a = pose.rotated(outline[i]);
    const PlanePoint b = pose.rotated(outline[(i + 1) % outline.size()]);
    const double across = std::min(std::abs(b.x - a.x), std::abs(b.y - a.y));
    if (distance(a, b) > 1e-6) worst = std::max(worst, across / distance(a, b));
  }
  return worst;
}

}  // namespace

TEST_CASE("a box lies level, in however many pieces its sides are", "[pack]") {
  std::mt19937 random(3);
  for (const unsigned pieces : {1u, 7u, 100u})
    for (double angle = 0.01; angle < 7; angle += 0.37) {
      const Outline outline = turnedBy(angle, box(3, 2, pieces, random));
      const LevelPose flat = levelOf(outline, {});
      CHECK(flat.isLevel);
      CHECK_FALSE(flat.isUpright);
      CHECK(skewness(outline, flat.pose) < 1e-6);
      CHECK(flat.pose.width == Approx(3));
      for (int quarter = 0; quarter < 4; ++quarter) {
        const PlanePoint up = turnedBy(angle + quarter * kPi / 2, {0, 1});
        const LevelPose standing = levelOf(outline, up);
        CHECK(standing.isUpright);
        CHECK(skewness(outline, standing.pose) < 1e-6);
        CHECK(standing.pose.rotated(up).y == Approx(1).epsilon(1e-9));
      }
    }
}

TEST_CASE("straight sides count more than crooked ones, and than what they lean by", "[pack]") {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> jitter(-0.1, 0.1);
  for (double angle = 0.01; angle < 3; angle += 0.37) {
    // Torn at the top.
    Outline outline = {{0, 0}, {3, 0}, {3, 2}};
    for (int k = 1; k < 30; ++k) outline.push_back({3 - 0.1 * k, 2 + jitter(random)});
    outline.push_back({0, 2});
    outline = turnedBy(angle, outline);
    const PlanePoint up = turnedBy(angle + 0.2, {0, 1});
    const Pose pose = levelOf(outline, up).pose;
    CHECK(pose.rotated(turnedBy(angle, {0, 1})).y == Approx(1).epsilon(1e-9));
  }
}

/// A standing A: its legs are its longest edges, 15 degrees off upright.
Outline letterA() {
  return {{0, 0}, {0.3, 0}, {0.45, 0.4}, {1.05, 0.4}, {1.2, 0}, {1.5, 0}, {0.95, 2}, {0.55, 2}};
}

TEST_CASE("what has level edges where it stands upright stands, though others are longer",
          "[pack]") {
  for (double angle = 0.01; angle < 7; angle += 0.37) {
    const PlanePoint up = turnedBy(angle, {0, 1});
    const LevelPose level = levelOf(turnedBy(angle, letterA()), up);
    CHECK(level.pose.rotated(up).y == Approx(1).epsilon(1e-9));
    CHECK(level.isLevel);
  }
}

TEST_CASE("straight sides are exactly upright where up is off by less than the eye sees",
          "[pack]") {
  std::mt19937 random(7);
  for (double angle = 0.01; angle < 7; angle += 0.37)
    for (const double lean : {-0.016, 0.012}) {
      const Outline strip = turnedBy(angle, box(1, 4, 5, random));
      const LevelPose level = levelOf(strip, turnedBy(angle + lean, {0, 1}));
      CHECK(skewness(strip, level.pose) < 1e-6);
      CHECK(level.pose.rotated(turnedBy(angle, {0, 1})).y == Approx(1).epsilon(1e-9));
    }
}

TEST_CASE("a disc has no direction of its own", "[pack]") {
  for (double angle = 0.01; angle < 3; angle += 0.37) {
    const Outline outline = turnedBy(angle, disc(200));
    const LevelPose flat = levelOf(outline, {});
    CHECK_FALSE(flat.isLevel);
    const Pose least = leastBoxPose(convexHull(outline));
    CHECK(flat.pose.cos == least.cos);
    CHECK(flat.pose.sin == least.sin);
    const PlanePoint up = turnedBy(2 * angle, {0, 0.7});
    const LevelPose standing = levelOf(outline, up);
    CHECK(standing.isUpright);
    CHECK(standing.pose.rotated(up).y == Approx(0.7).epsilon(1e-3));
    // It gains too little height to stand.
    CHECK_FALSE(levelOf(outline, turnedBy(angle, {0, 0.2})).isUpright);
  }
}

TEST_CASE("what has no straight side stands exactly upright", "[pack]") {
  Outline outline;
  for (int k = 0; k < 300; ++k) {
    const double angle = 2 * kPi * k / 300, radius = 2 + std::sin(3 * angle + 1);
    outline.push_back({radius * std::cos(angle), 0.7 * radius * std::sin(angle)});
  }
  for (double angle = 0.01; angle < 7; angle += 0.37) {
    const LevelPose level = levelOf(outline, turnedBy(angle, {0, 0.9}));
    CHECK(level.pose.rotated(turnedBy(angle, {0, 0.9})).y > 0.9 * std::cos(0.2));
  }
}

TEST_CASE("how a shape was turned before does not matter", "[pack]") {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> angles(0, 2 * kPi);
  for (const char* kind : {"stars", "letters", "rectangles", "blobs", "triangles"})
    for (const PackShape& shape : test::makePackShapes(kind, 10, 5, 2)) {
      CAPTURE(kind);
      const Outline outline = coveringLoops(shape).points;
      const PlanePoint up = turnedBy(angles(random), {0.8, 0});
      for (const PlanePoint& gained : {PlanePoint{}, up}) {
        const double angle = angles(random);
        const LevelPose a = levelOf(outline, gained);
        const LevelPose b = levelOf(turnedBy(angle, outline), turnedBy(angle, gained));
        CHECK(a.isLevel == b.isLevel);
        CHECK(a.isUpright == b.isUpright);
        CHECK(a.pose.width == Approx(b.pose.width).epsilon(1e-6));
        CHECK(a.pose.height == Approx(b.pose.height).epsilon(1e-6));
        CHECK(a.pose.rotated(gained).y ==
              Approx(b.pose.rotated(turnedBy(angle, gained)).y).margin(1e-6));
      }
    }
}

TEST_CASE("poses of nothing, of a point and of numbers that are not finite", "[pack]") {
  CHECK(levelOf({}, {}).pose.width == 0);
  CHECK(levelOf({{1, 2}}, {0, 1}).pose.width == 0);
  CHECK(levelOf({{1, 2}, {1, 2}, {1, 2}}, {0, 1}).pose.height == 0);
  const LevelPose level = levelOf({{0, 0}, {1, 0}, {0, 1}}, {HUGE_VAL, 1});
  CHECK_FALSE(level.isUpright);
  CHECK(std::isfinite(level.pose.width));
}
