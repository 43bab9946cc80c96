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

TEST_CASE("the side of a new image is the power of two that is nearest, within bounds") {
  const auto sideFor = [](std::uint32_t texels, double scale = 1) {
    const Image texture(texels, texels, 1);
    BakeInput input = squareWith(texture, unchanged);
    input.materials[0].scale = {scale, scale};
    return bakeSize(input, 0, 0).width;
  };
  CHECK(sideFor(64) == 64);
  // sqrt(2) is between.
  CHECK(sideFor(90) == 64);
  CHECK(sideFor(91) == 128);
  CHECK(sideFor(2) == 16);
  CHECK(sideFor(64, 1e4) == 8192);
  const Image texture(64, 64, 1);
  BakeInput input = squareWith(texture, unchanged);
  input.materials[0].texture = kNoTexture;
  CHECK(bakeSize(input, 0, 0) == 1024);
  CHECK(bakeSize(input, 0, 300) == 300);
  CHECK(bakeSize(input, 0, 32768) == 8192);
}

TEST_CASE("a new image has the shape of the layout, unless another is asked for") {
  const Image texture(64, 64, 1);
  BakeInput input = squareWith(texture, unchanged);
  CHECK(bakeSize(input, 0, {512, 256}) == AtlasSize(128, 64));
  CHECK(bakeSize(input, 0, {256, 1024}) == AtlasSize(32, 128));
  CHECK(bakeSize(input, 100, {512, 256}) == AtlasSize(100, 50));
  CHECK(bakeSize(input, {100, 300}, {512, 256}) == AtlasSize(100, 300));
  CHECK(bakeSize(input, {100, 300}, 0) == AtlasSize(100, 300));
  input.materials[0].texture = kNoTexture;
  CHECK(bakeSize(input, 0, {512, 256}) == AtlasSize(512, 256));
  CHECK(bakeSize(input, 0, {32768, 64}) == AtlasSize(8192, 16));
  CHECK(bakePadding(4, {256, 128}, {512, 256}) == 2);
  CHECK(bakePadding(3, {256, 128}, {512, 256}) == 2);
  CHECK(bakePadding(3, {256, 128}, 0) == 3);
}
