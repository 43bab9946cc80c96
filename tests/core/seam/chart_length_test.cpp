#include "seam/chart_length.h"

#include <algorithm>
#include <cmath>

#include "catch.h"
#include "support/cut_meshes.h"
#include "support/squares.h"

using namespace abflat;
using namespace abflat::test;

namespace {

bool everywhere(std::uint32_t, std::uint32_t) { return true; }

/// A strip of squares, 1 wide, laid out along a line or around part of a circle.
struct Strip {
  Cuttable cuttable;
  CutSurface surface;
  IdVector<OpenVertex, PlanePoint> at;

  /// `turn`: how much the strip turns in all.
  Strip(unsigned squaresAlong, double turn) : cuttable(squares(squaresAlong, 3, everywhere)) {
    const SeamMesh& m = cuttable.seamMesh;
    surface = cutAlong(m, Seams(m.twin.size(), 0));
    double width = 0, height = 0;
    for (const SurfaceVertex v : surface.meshVertex) {
      width = std::max(width, m.positions[3 * v]);
      height = std::max(height, m.positions[3 * v + 1]);
    }
    const double length = squaresAlong / 3.0, radius = turn > 0 ? length / turn : 0;
    for (const SurfaceVertex v : surface.meshVertex) {
      const double x = length * m.positions[3 * v] / width, y = m.positions[3 * v + 1] / height;
      const double r = radius + 0.5 - y, angle = turn * x / length;
      at.push_back(turn > 0 ? PlanePoint{r * std::sin(angle), -r * std::cos(angle)}
                            : PlanePoint{x, y});
    }
  }

  double distance(const AcrossPlace& p) const {
    return std::hypot(at[p.before].x - at[p.after].x, at[p.before].y - at[p.after].y);
  }
};

}  // namespace

TEST_CASE("a strip is divided straight across into equal parts, however it bends", "[room]") {
  for (const unsigned along : {60u, 300u})
    for (const double turn : {0.0, 1.5, 3.0, 5.5}) {
      const Strip strip(along, turn);
      const ChartLength length(strip.surface, strip.at, CutChartId(0));
      INFO(along << " squares, turning by " << turn);
      // The inner side of a bend is shorter.
      CHECK(length.length() >= along / 3.0 - turn / 2);
      CHECK(length.length() <= along / 3.0 + 2);
      for (const int parts : {2, 3, 7}) {
        const std::vector<AcrossPlace> places = length.places(parts);
        REQUIRE(places.size() == static_cast<std::size_t>(parts - 1));
        for (std::size_t i = 0; i < places.size(); ++i) {
          CHECK(strip.distance(places[i]) == Approx(1).margin(0.35));
          const PlanePoint before = strip.at[places[i].before];
          if (turn > 0) continue;
          const double share = before.x / (along / 3.0);
          const double expected = static_cast<double>(i + 1) / parts;
          CHECK(std::min(std::abs(share - expected), std::abs(1 - share - expected)) < 0.06);
        }
      }
    }
}

TEST_CASE("a strip is divided at preferred vertices if some are near", "[room]") {
  const Strip strip(60, 0);
  const auto preferring = [&](double from, double to) {
    IdVector<OpenVertex, std::uint8_t> isPreferred;
    for (const PlanePoint& p : strip.at) isPreferred.push_back(p.x >= from && p.x <= to);
    return ChartLength(strip.surface, strip.at, CutChartId(0), isPreferred);
  };
  const ChartLength beside = preferring(7, 7.5), atEnd = preferring(0, 1);
  CHECK(beside.hasPreferred());
  CHECK_FALSE(atEnd.hasPreferred());
  CHECK_FALSE(preferring(30, 31).hasPreferred());
  for (const AcrossPlace& place : beside.places(2)) {
    CHECK(strip.at[place.before].x == Approx(7.25).margin(0.26));
    CHECK(strip.distance(place) == Approx(1).margin(0.35));
  }
  CHECK(strip.at[atEnd.places(2).at(0).before].x == Approx(10).margin(1.2));
}

TEST_CASE("a strip has no more places across than its outline has vertices", "[room]") {
  const Strip strip(9, 0);
  const ChartLength length(strip.surface, strip.at, CutChartId(0));
  const std::vector<AcrossPlace> places = length.places(500);
  CHECK(places.size() >= 5);
  CHECK(places.size() <= 14);
  for (std::size_t i = 1; i < places.size(); ++i) {
    CHECK(places[i].before != places[i - 1].before);
    CHECK(places[i].after != places[i - 1].after);
  }
}
