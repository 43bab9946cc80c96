#include "islands/check_places.h"

#include "catch.h"

using namespace abflat;

namespace {

/// Two triangles; the second is moved along u.
PlacedTriangles trianglesAt(double u, std::uint32_t stackOfSecond) {
  return {{0.1, 0.1, 0.3, 0.1, 0.1, 0.3, 0.1 + u, 0.1, 0.1 + u, 0.3, 0.3 + u, 0.1},
          {4, 7},
          {0, stackOfSecond}};
}

}  // namespace

TEST_CASE("check places: stacks must not overlap each other") {
  CHECK(problemOf(trianglesAt(0.5, 1), 1).empty());
  CHECK(problemOf(trianglesAt(0.1, 1), 1) ==
        "the islands of faces 4 and 7 overlap, which lay apart");
  CHECK(problemOf(trianglesAt(0.1, 0), 1).empty());
}

TEST_CASE("check places: each lies in one of the tiles") {
  CHECK(problemOf(trianglesAt(0.8, 1), 2) == "the island of face 7 leaves its tile");
  CHECK(problemOf(trianglesAt(1, 1), 1) == "the island of face 7 leaves its tile");
  CHECK(problemOf(trianglesAt(1, 1), 2).empty());
  CHECK(problemOf(trianglesAt(-0.5, 1), 2) == "the island of face 7 leaves its tile");
  CHECK(problemOf(trianglesAt(10, 1), 30) == "the island of face 7 leaves its tile");
}
