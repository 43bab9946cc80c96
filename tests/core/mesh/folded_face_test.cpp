#include "mesh/folded_face.h"

#include <random>
#include <set>

#include "catch.h"

using namespace abflat;

namespace {

/// Walks along edges of a random tree and back to the start, sometimes staying in place.
std::vector<std::uint32_t> randomWalk(std::mt19937& random, std::uint32_t& next, int depth) {
  const std::uint32_t here = next++;
  std::vector<std::uint32_t> out = {here};
  for (std::uint32_t n = random() % 4; n > 0 && depth < 5; --n) {
    for (const std::uint32_t place : randomWalk(random, next, depth + 1)) out.push_back(place);
    for (std::uint32_t k = 1 + random() % 2; k > 0; --k) out.push_back(here);
  }
  return out;
}

}  // namespace

TEST_CASE("a face that goes there and back again has triangles without area", "[mesh]") {
  std::mt19937 random(5);
  for (int i = 0; i < 300; ++i) {
    std::uint32_t next = 0;
    std::vector<std::uint32_t> places = randomWalk(random, next, 0);
    if (places.size() < 3) continue;
    std::rotate(places.begin(), places.begin() + random() % places.size(), places.end());
    const auto triangles = foldedTriangles(places);
    REQUIRE(triangles.size() == places.size() - 2);
    std::set<std::uint32_t> corners;
    for (const auto& t : triangles) {
      CHECK(std::set{places[t[0]], places[t[1]], places[t[2]]}.size() < 3);
      CHECK(std::set{t[0], t[1], t[2]}.size() == 3);
      corners.insert(t.begin(), t.end());
    }
    CHECK(corners.size() == places.size());
  }
}
