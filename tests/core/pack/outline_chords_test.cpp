#include "pack/outline_chords.h"

#include <algorithm>
#include <cmath>

#include "catch.h"

using namespace abflat;

namespace {

/// Adds points between the corners, about 1 apart.
std::vector<PlanePoint> outlineOf(const std::vector<PlanePoint>& corners) {
  std::vector<PlanePoint> out;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const PlanePoint a = corners[i], b = corners[(i + 1) % corners.size()];
    const int steps = std::max(1, static_cast<int>(std::hypot(b.x - a.x, b.y - a.y)));
    for (int k = 0; k < steps; ++k)
      out.push_back({a.x + (b.x - a.x) * k / steps, a.y + (b.y - a.y) * k / steps});
  }
  return out;
}

}  // namespace

TEST_CASE("chords of a strip lead straight across it, at both ends and in its middle", "[room]") {
  const std::vector<PlanePoint> strip = outlineOf({{0, 0}, {40, 0}, {40, 4}, {0, 4}});
  const std::vector<OutlineChord> chords = outlineChords(strip);
  REQUIRE(chords.size() > 5);
  int across = 0;
  bool isMiddle = false;
  for (const OutlineChord& c : chords) {
    if (c.length != Approx(4)) continue;
    ++across;
    CHECK(strip[c.from].x == Approx(strip[c.to].x));
    isMiddle = isMiddle || std::abs(c.share - 0.5) < 0.11;
  }
  CHECK(across >= 9);
  CHECK(isMiddle);
}

TEST_CASE("chords stay inside", "[room]") {
  // A U: the shortest lines between its arms lie outside.
  const std::vector<PlanePoint> u =
      outlineOf({{0, 0}, {12, 0}, {12, 20}, {8, 20}, {8, 4}, {4, 4}, {4, 20}, {0, 20}});
  const auto isInside = [](double x, double y) {
    return x >= 0 && x <= 12 && y >= 0 && y <= 20 && !(x > 4 && x < 8 && y > 4);
  };
  for (const OutlineChord& c : outlineChords(u))
    for (double t = 0.01; t < 1; t += 0.02)
      CHECK(isInside(u[c.from].x + t * (u[c.to].x - u[c.from].x),
                     u[c.from].y + t * (u[c.to].y - u[c.from].y)));
}

TEST_CASE("chords go along the creases of a net, whose edges lie on the same lines", "[room]") {
  // A cross: each arm is held by a crease between two notches.
  const std::vector<PlanePoint> cross = outlineOf({{2, 0},
                                                   {6, 0},
                                                   {6, 2},
                                                   {8, 2},
                                                   {8, 6},
                                                   {6, 6},
                                                   {6, 8},
                                                   {2, 8},
                                                   {2, 6},
                                                   {0, 6},
                                                   {0, 2},
                                                   {2, 2}});
  std::vector<std::uint8_t> isNotch;
  for (const PlanePoint& p : cross)
    isNotch.push_back((p.x == 2 || p.x == 6) && (p.y == 2 || p.y == 6));
  const std::vector<OutlineChord> chords = outlineChords(cross, isNotch);
  const auto cutsOff = [](const OutlineChord& c) { return c.smallerShare() == Approx(1.0 / 6); };
  CHECK(std::count_if(chords.begin(), chords.end(), cutsOff) == 4);
  for (const OutlineChord& c : chords) CHECK((isNotch[c.from] && isNotch[c.to]));
}
