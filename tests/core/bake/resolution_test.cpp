#include <cmath>

#include "abflat/bake.h"
#include "bake/baked.h"

using namespace abflat;
using test::addQuad;
using test::Image;
using test::squareWith;
using test::unchanged;

TEST_CASE("a resolution that keeps the density of the old textures") {
  const Image texture(64, 32, 1);
  BakeInput input = squareWith(texture, unchanged);
  input.triangles = {};
  addQuad(input.triangles, {0, 0}, {0.5, 0}, {0, 0.5}, unchanged);
  CHECK(bakeResolution(input) == Approx(std::sqrt(64 * 32)));
  input.materials[0].scale = {2, 0.5};
  CHECK(bakeResolution(input) == Approx(std::sqrt(64 * 32)));
  // Less than half of the area does not matter.
  addQuad(input.triangles, {0.5, 0.5}, {0.4, 0}, {0, 0.4}, [](const Point2& p) {
    return Point2{9 * p[0], 9 * p[1]};
  });
  CHECK(bakeResolution(input) == Approx(std::sqrt(64 * 32)));
  addQuad(input.triangles, {0.5, 0.5}, {0.4, 0}, {0, 0.4}, [](const Point2& p) {
    return Point2{9 * p[0], 9 * p[1]};
  });
  CHECK(bakeResolution(input) == Approx(9 * std::sqrt(64 * 32)));
  input.materials[0].texture = kNoTexture;
  CHECK(bakeResolution(input) == 0);
}
