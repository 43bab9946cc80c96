#include "mesh/face_walk.h"

#include "catch.h"

using namespace abflat;

namespace {

/// Two squares that meet at vertex 0, with vertices 7 and 8 within the first one, 9 outside.
const std::vector<double> kPlaces{0,  0,  0, 4, 0,  0, 4, 4, 0, 0, 4, 0, -4, 0, 0,
                                  -4, -4, 0, 0, -4, 0, 2, 1, 0, 1, 2, 0, 6,  7, 0};

FaceWalk walk(const std::vector<std::uint32_t>& places) { return walkAround(kPlaces, places); }

}  // namespace

TEST_CASE("a walk keeps a spike within the face, and leaves out one outside", "[polygons]") {
  const FaceWalk within = walk({0, 1, 2, 7, 2, 3});
  CHECK(within.corners == CornerLoop{0, 1, 2, 3, 4, 5});
  CHECK(within.opening.corners.empty());
  CHECK(walk({0, 1, 2, 9, 2, 3}).corners == CornerLoop{0, 1, 2, 5});
  CHECK(walk({2, 3, 0, 1, 2, 9}).corners.size() == 4);
  CHECK(walk({9, 2, 3, 0, 1, 2}).corners.size() == 4);
  // A spike that branches, inside and outside.
  CHECK(walk({0, 1, 2, 7, 8, 7, 2, 3}).corners.size() == 8);
  CHECK(walk({0, 1, 2, 3, 0, 5, 6, 5, 4, 5}).corners.size() == 4);
}

TEST_CASE("a walk opens where pieces meet", "[polygons]") {
  const FaceWalk eight = walk({0, 1, 2, 3, 0, 4, 5, 6});
  CHECK(eight.corners.size() == 8);
  CHECK(eight.opening.corners.size() == 2);
  CHECK(eight.opening.points.size() == 2);
  // A bridge from piece to piece.
  const FaceWalk bridged = walk({0, 1, 2, 3, 0, 5, 6, 4, 5});
  CHECK(bridged.corners.size() == 9);
  // Those of a hole that touches the outline stay: there is one piece.
  CHECK(walk({0, 1, 2, 3, 0, 8, 7}).opening.corners.empty());
}

TEST_CASE("a walk without area has no polygon left", "[polygons]") {
  CHECK(walk({0, 1, 0, 2, 0, 3}).corners.size() < 3);
  CHECK(walk({0, 1, 2, 1}).corners.size() < 3);
  CHECK(walk({0, 1, 1, 0}).corners.size() < 3);
  CHECK(walk({2, 2, 2}).corners.size() < 3);
}

TEST_CASE("a walk has no corner twice in a row", "[polygons]") {
  CHECK(walk({0, 1, 1, 2, 2, 2, 3, 0, 0, 8, 7, 0}).corners == CornerLoop{0, 1, 3, 6, 7, 9, 10});
}
