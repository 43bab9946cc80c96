#include "bake/painter.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "bake/baked.h"
#include "base/constants.h"

using namespace abflat;
using test::asLargeAs;
using test::baked;
using test::centreOf;
using test::encoded;
using test::Image;
using test::linearised;
using test::noise;
using test::squareWith;
using test::unchanged;

namespace {

std::int64_t slowlyWrapped(std::int64_t i, std::int64_t count, Wrap wrap) {
  if (wrap == Wrap::Clamp) return std::clamp<std::int64_t>(i, 0, count - 1);
  while (i < 0) i += 2 * count;
  while (i >= 2 * count) i -= 2 * count;
  if (i < count) return i;
  return wrap == Wrap::Repeat ? i - count : 2 * count - 1 - i;
}

/// Bilinear, of numbers as they are.
double slowSample(const Image& image, double u, double v, int channel, Wrap wrapU, Wrap wrapV) {
  const double x = u * image.width - 0.5, y = v * image.height - 0.5;
  double sum = 0;
  for (int dy = 0; dy < 2; ++dy)
    for (int dx = 0; dx < 2; ++dx) {
      const double i = std::floor(x) + dx, j = std::floor(y) + dy;
      const double share = (1 - std::abs(x - i)) * (1 - std::abs(y - j));
      const auto column = slowlyWrapped(static_cast<std::int64_t>(i), image.width, wrapU);
      const auto row = slowlyWrapped(static_cast<std::int64_t>(j), image.height, wrapV);
      sum += share *
             image.at(static_cast<std::size_t>(column), static_cast<std::size_t>(row), channel);
    }
  return sum;
}

}  // namespace

TEST_CASE("a layout that stays gives the same pixels") {
  for (const int bits : {8, 16})
    for (int channels = 1; channels <= 4; ++channels)
      for (const ColourSpace space : {ColourSpace::Srgb, ColourSpace::Linear}) {
        const Image image = noise(37, 23, channels, bits, 5);
        BakeInput input = squareWith(image, unchanged);
        input.textures[0].space = space;
        BakeOptions options = asLargeAs(image);
        options.space = space;
        CAPTURE(bits, channels);
        CHECK(baked(input, options).bytes == image.bytes);
        input.textures[0].alphaIsOpacity = false;
        CHECK(baked(input, options).bytes == image.bytes);
      }
}

TEST_CASE("turned by a right angle, an image keeps its pixels") {
  const Image image = noise(32, 32, 3, 8, 6);
  const BakeInput input = squareWith(image, [](const Point2& p) { return Point2{1 - p[1], p[0]}; });
  const Image out = baked(input, asLargeAs(image));
  for (std::size_t y = 0; y < 32; ++y)
    for (std::size_t x = 0; x < 32; ++x) REQUIRE(out.pixel(x, y) == image.pixel(31 - y, x));
}

TEST_CASE("an image that shrinks is the mean of what each texel covers, in linear light") {
  Image board(64, 64, 3);
  for (std::size_t y = 0; y < 64; ++y)
    for (std::size_t x = 0; x < 64; ++x)
      for (int d = 0; d < 3; ++d) board.set(x, y, d, (x + y) % 2 ? 255 : 0);
  const Image image = noise(64, 64, 3, 8, 7);
  for (const std::uint32_t factor : {2u, 4u, 8u}) {
    BakeOptions options = asLargeAs(board);
    options.width = options.height = 64 / factor;
    const Image grey = baked(squareWith(board, unchanged), options);
    for (const std::uint8_t byte : grey.bytes) REQUIRE(byte == 188);  // 255 encoded(1/2)
    const Image small = baked(squareWith(image, unchanged), options);
    for (std::size_t y = 0; y < small.height; ++y)
      for (std::size_t x = 0; x < small.width; ++x) {
        double sum = 0;
        for (std::size_t k = 0; k < factor * factor; ++k)
          sum += linearised(image.at(x * factor + k % factor, y * factor + k / factor, 1) / 255.0);
        REQUIRE(small.at(x, y, 1) == Approx(255 * encoded(sum / factor / factor)).margin(0.51));
      }
  }
  SECTION("along one axis alone") {
    BakeOptions options = asLargeAs(image);
    options.height = 16;
    const Image low = baked(squareWith(image, unchanged), options);
    for (std::size_t y = 0; y < 16; ++y)
      for (std::size_t x = 0; x < 64; ++x) {
        double sum = 0;
        for (std::size_t k = 0; k < 4; ++k) sum += linearised(image.at(x, 4 * y + k, 0) / 255.0);
        REQUIRE(low.at(x, y, 0) == Approx(255 * encoded(sum / 4)).margin(0.51));
      }
  }
  SECTION("by any factor, with nothing but grey left of fine stripes") {
    Image stripes(300, 300, 1);
    for (std::size_t y = 0; y < 300; ++y)
      for (std::size_t x = 0; x < 300; ++x) stripes.set(x, y, 0, x % 2 ? 255 : 0);
    BakeInput input = squareWith(stripes, unchanged);
    input.textures[0].space = ColourSpace::Linear;
    BakeOptions options = asLargeAs(stripes);
    options.space = ColourSpace::Linear;
    options.width = options.height = 97;
    for (const std::uint8_t byte : baked(input, options).bytes)
      REQUIRE(static_cast<int>(byte) == Approx(127.5).margin(16));
    options.width = options.height = 37;
    for (const std::uint8_t byte : baked(input, options).bytes)
      REQUIRE(static_cast<int>(byte) == Approx(127.5).margin(2));
  }
}

TEST_CASE("a ramp stays one in a layout that is turned") {
  Image ramp(256, 256, 2, 16);
  for (std::size_t y = 0; y < 256; ++y)
    for (std::size_t x = 0; x < 256; ++x) {
      ramp.set(x, y, 0, static_cast<int>(x * 257));
      ramp.set(x, y, 1, static_cast<int>(y * 257));
    }
  const double c = std::cos(37 * kPi / 180), s = std::sin(37 * kPi / 180);
  const auto toOld = [&](const Point2& p) {
    const double x = p[0] - 0.5, y = p[1] - 0.5;
    return Point2{0.5 + 0.6 * (c * x - s * y), 0.5 + 0.6 * (s * x + c * y)};
  };
  BakeInput input = squareWith(ramp, toOld);
  input.textures[0].space = ColourSpace::Linear;
  input.textures[0].alphaIsOpacity = false;
  BakeOptions options = asLargeAs(ramp);
  options.space = ColourSpace::Linear;
  options.bits = 8;
  options.width = options.height = 200;
  const Image out = baked(input, options);
  for (std::size_t y = 0; y < 200; ++y)
    for (std::size_t x = 0; x < 200; ++x) {
      const Point2 old = toOld({centreOf(x, y)[0] / 200, centreOf(x, y)[1] / 200});
      REQUIRE(std::abs(out.at(x, y, 0) - (256 * old[0] - 0.5)) <= 1);
      REQUIRE(std::abs(out.at(x, y, 1) - (256 * old[1] - 0.5)) <= 1);
    }
}

TEST_CASE("textures go on beyond their edges, and are scaled, turned and moved") {
  const Image image = noise(13, 7, 1, 16, 8);
  const auto toOld = [](const Point2& p) {
    return Point2{3 * p[0] - 1.4 + 0.2 * p[1], 3 * p[1] - 1.6};
  };
  const std::array wraps = {Wrap::Repeat, Wrap::Mirror, Wrap::Clamp};
  for (const Wrap wrapU : wraps)
    for (const Wrap wrapV : wraps) {
      BakeInput input = squareWith(image, toOld);
      input.textures[0].wrapU = wrapU;
      input.textures[0].wrapV = wrapV;
      input.textures[0].space = ColourSpace::Linear;
      BakeMaterial& material = input.materials[0];
      material.rotation = 0.4;
      material.scale = {0.9, -1.2};
      material.offset = {0.3, 0.05};
      BakeOptions options = asLargeAs(image);
      options.space = ColourSpace::Linear;
      options.width = options.height = 80;
      const Image out = baked(input, options);
      for (std::size_t y = 0; y < 80; ++y)
        for (std::size_t x = 0; x < 80; ++x) {
          const Point2 p = toOld({centreOf(x, y)[0] / 80, centreOf(x, y)[1] / 80});
          const double c = std::cos(0.4), s = std::sin(0.4);
          const double u = c * 0.9 * p[0] + s * -1.2 * p[1] + 0.3;
          const double v = -s * 0.9 * p[0] + c * -1.2 * p[1] + 0.05;
          REQUIRE(out.at(x, y, 0) == Approx(slowSample(image, u, v, 0, wrapU, wrapV)).margin(1));
        }
    }
}

TEST_CASE("transparent texels do not bleed") {
  Image image(64, 64, 4);  // opaque green and transparent red, in stripes
  for (std::size_t y = 0; y < 64; ++y)
    for (std::size_t x = 0; x < 64; ++x) {
      image.set(x, y, 0, x % 2 ? 255 : 0);
      image.set(x, y, 1, x % 2 ? 0 : 255);
      image.set(x, y, 3, x % 2 ? 0 : 255);
    }
  BakeOptions options = asLargeAs(image);
  for (const std::uint32_t side : {32u, 21u, 16u, 100u}) {
    options.width = options.height = side;
    const Image out = baked(squareWith(image, unchanged), options);
    for (std::size_t y = 0; y < side; ++y)
      for (std::size_t x = 0; x < side; ++x) {
        if (out.at(x, y, 3) == 0) continue;
        REQUIRE(out.at(x, y, 0) == 0);
        REQUIRE(out.at(x, y, 1) == 255);
      }
    if (side < 32) CHECK(out.at(8, 8, 3) == Approx(128).margin(10));
  }
}

TEST_CASE("factors and colours of corners are multiplied, also without a texture") {
  BakeInput input = squareWith(Image(1, 1, 4), unchanged);
  input.materials[0].texture = kNoTexture;
  input.materials[0].factor = {0.5, 1, 2, 0.25};
  for (int corner = 0; corner < 6; ++corner)
    input.triangles.colours.insert(input.triangles.colours.end(), {0.5f, 0.2f, 0.75f, 1});
  BakeOptions options;
  options.width = options.height = 4;
  options.space = ColourSpace::Linear;
  const Image out = baked(input, options);
  CHECK(out.pixel(2, 1) == std::vector<int>{64, 51, 255, 64});
  // From 0 on the left to 1 on the right.
  for (std::size_t corner = 0; corner < 6; ++corner)
    input.triangles.colours[4 * corner + 1] = static_cast<float>(input.triangles.uv[2 * corner]);
  CHECK(baked(input, options).at(1, 3, 1) == 96);
}
