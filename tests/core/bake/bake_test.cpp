#include "abflat/bake.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "bake/baked.h"

using namespace abflat;
using test::addQuad;
using test::addTriangle;
using test::asLargeAs;
using test::baked;
using test::centreOf;
using test::Image;
using test::noise;
using test::squareWith;
using test::unchanged;

namespace {

/// A layout of small and large charts with gaps, of which one is partly outside.
BakeInput manyCharts(const Image& texture) {
  BakeInput out = squareWith(texture, unchanged);
  out.triangles = {};
  const auto toOld = [](const Point2& p) {
    return Point2{3 * p[1] - 0.2 * p[0], 1.1 * p[0] + 0.3};
  };
  addQuad(out.triangles, {0.05, 0.1}, {0.3, 0.1}, {-0.02, 0.2}, toOld);
  addQuad(out.triangles, {0.5, 0.07}, {0.02, 0.01}, {-0.02, 0.8}, toOld);
  addQuad(out.triangles, {0.7, 0.7}, {0.001, 0.1}, {0.1, 0.003}, toOld);
  addQuad(out.triangles, {0.9, -0.2}, {0.3, 0.1}, {0, 0.9}, toOld);
  return out;
}

/// Whether a point, in pixels of an image of this size, lies in a triangle or on its outline.
bool isCovered(const BakeTriangles& triangles, const BakeOptions& size, const Point2& p) {
  for (std::size_t t = 0; t < triangles.count(); ++t) {
    bool isLeft = false, isRight = false;  // of an edge
    for (std::size_t k = 0; k < 3; ++k) {
      const double* const a = &triangles.uv[6 * t + 2 * k];
      const double* const b = &triangles.uv[6 * t + 2 * ((k + 1) % 3)];
      const double dx = (b[0] - a[0]) * size.width, dy = (b[1] - a[1]) * size.height;
      const double side = dx * (p[1] - a[1] * size.height) - dy * (p[0] - a[0] * size.width);
      isLeft = isLeft || side < -1e-9;
      isRight = isRight || side > 1e-9;
    }
    if (!isLeft || !isRight) return true;
  }
  return false;
}

}  // namespace

TEST_CASE("texels around a chart have the colour of the nearest texel within") {
  const Image texture = noise(50, 50, 4, 8, 9);
  const BakeInput input = manyCharts(texture);
  BakeOptions options = asLargeAs(texture);
  options.width = 90;
  options.height = 70;
  options.background = {1, 0, 1, 0.2};
  options.padding = 0;
  std::vector<std::array<std::size_t, 2>> covered;
  for (std::size_t y = 0; y < 70; ++y)
    for (std::size_t x = 0; x < 90; ++x)
      if (isCovered(input.triangles, options, centreOf(x, y))) covered.push_back({x, y});
  for (const std::uint32_t padding : {0u, 3u, 1000u}) {
    options.padding = padding;
    const Image out = baked(input, options);
    for (std::size_t y = 0; y < 70; ++y)
      for (std::size_t x = 0; x < 90; ++x) {
        double least = 1e9;
        std::vector<std::vector<int>> nearest;
        for (const auto& [i, j] : covered) {
          const Point2 p = centreOf(x, y), q = centreOf(i, j);
          const double distance = std::pow(p[0] - q[0], 2) + std::pow(p[1] - q[1], 2);
          if (distance < least) nearest.clear();
          least = std::min(least, distance);
          if (distance == least) nearest.push_back(out.pixel(i, j));
        }
        const std::vector<int> pixel = out.pixel(x, y);
        CAPTURE(x, y, least, padding);
        if (std::sqrt(least) > padding + 1.5)
          REQUIRE(pixel == std::vector<int>{255, 0, 255, 51});
        else
          REQUIRE(std::count(nearest.begin(), nearest.end(), pixel) > 0);
      }
  }
  options.padding = 1000;
  const Image all = baked(input, options);
  options.padding = 2;
  options.fillsAll = true;
  CHECK(baked(input, options).bytes == all.bytes);
}

TEST_CASE("what is narrower than a texel still has its colour") {
  Image texture(4, 4, 3);
  for (std::size_t i = 0; i < 16; ++i) texture.set(i % 4, i / 4, 1, 200);
  BakeInput input = squareWith(texture, unchanged);
  input.triangles = {};
  addQuad(input.triangles, {0.101, 0.1}, {0.0003, 0}, {0, 0.8}, unchanged);
  addTriangle(input.triangles, {{{0.5, 0.512}, {0.5001, 0.512}, {0.5, 0.5121}}}, unchanged);
  BakeOptions options = asLargeAs(texture);
  options.width = options.height = 64;
  options.padding = 0;
  const Image out = baked(input, options);
  CHECK(out.at(6, 30, 1) == 200);
  CHECK(out.at(32, 32, 1) == 200);
  CHECK(out.at(50, 50, 1) == 0);
}

TEST_CASE("bands of any height and any number of threads give the same image") {
  const Image texture = noise(50, 50, 4, 8, 10);
  BakeInput input = manyCharts(texture);
  addTriangle(input.triangles, {{{0.15, 0.6}, {0.1502, 0.6}, {0.15, 0.6003}}}, unchanged);
  addQuad(input.triangles, {0.35, 0.501}, {0.1, 0.0002}, {0.0001, 0.0003}, unchanged);
  BakeOptions options = asLargeAs(texture);
  options.width = 150;
  options.height = 131;
  for (const bool fillsAll : {false, true}) {
    options.fillsAll = fillsAll;
    options.bandRows = 1000;
    options.threads = 1;
    const Image whole = baked(input, options);
    for (const std::uint32_t rows : {1u, 2u, 7u, 64u})
      for (const int threads : {1, 3}) {
        options.bandRows = rows;
        options.threads = threads;
        CAPTURE(rows, threads, fillsAll);
        CHECK(baked(input, options).bytes == whole.bytes);
      }
  }
}

TEST_CASE("neighbours leave no gap, and the first of overlapping triangles wins") {
  const Image texture(1, 1, 1);
  BakeInput input = squareWith(texture, unchanged);
  input.materials[0].texture = kNoTexture;
  input.materials.push_back(input.materials[0]);
  input.materials[1].factor = {0, 0, 0, 0};
  input.triangles = {};
  std::mt19937 random(4);
  std::uniform_real_distribution<double> coordinate(0.01, 0.99);
  const std::array<Point2, 4> square = {Point2{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const Point2 middle = {coordinate(random), coordinate(random)};
  for (std::size_t k = 0; k < 4; ++k)
    addTriangle(input.triangles, {square[k], square[(k + 1) % 4], middle}, unchanged);
  addQuad(input.triangles, {0, 0}, {1, 0}, {0, 1}, unchanged);
  input.triangles.materials[4] = input.triangles.materials[5] = 1;
  BakeOptions options = asLargeAs(texture);
  options.width = options.height = 200;
  for (const std::uint8_t byte : baked(input, options).bytes) REQUIRE(byte == 255);
}

TEST_CASE("what a map cannot be made from is named") {
  const Image texture(2, 2, 4);
  const BakeInput good = squareWith(texture, unchanged);
  const BakeOptions options = asLargeAs(texture);
  const auto fails = [](const BakeInput& input, const BakeOptions& with) {
    const Status status = bake(input, with, [](auto, auto, const auto&) { return true; });
    CHECK(!status.message.empty());
    return status.code;
  };
  BakeInput input = good;
  input.triangles.oldUv[7] = std::numeric_limits<double>::infinity();
  CHECK(fails(input, options) == StatusCode::InvalidMesh);
  input = good;
  input.triangles.uv.pop_back();
  CHECK(fails(input, options) == StatusCode::InvalidMesh);
  input = good;
  input.triangles.materials[1] = 1;
  CHECK(fails(input, options) == StatusCode::InvalidMesh);
  input = good;
  input.materials[0].texture = 3;
  CHECK(fails(input, options) == StatusCode::InvalidOption);
  input = good;
  input.textures[0].image.bits = 12;
  CHECK(fails(input, options) == StatusCode::InvalidOption);
  BakeOptions other = options;
  other.width = 0;
  CHECK(fails(good, other) == StatusCode::InvalidOption);
  other = options;
  other.kind = MapKind::Normal;
  CHECK(fails(good, other) == StatusCode::InvalidMesh);
  CHECK(bake(good, options, [](auto, auto, const auto&) { return false; }).code ==
        StatusCode::Aborted);
}

TEST_CASE("uv of any size and triangles without area do no harm") {
  const Image texture = noise(8, 8, 3, 8, 3);
  BakeInput input = squareWith(texture, [](const Point2& p) {
    return Point2{1e300 * p[0], -1e300 * p[1]};
  });
  addTriangle(input.triangles, {{{1e300, 0}, {0, 1e300}, {-1e300, -1e300}}}, unchanged);
  const auto toFar = [](const Point2& p) { return Point2{1e9 * p[0], 1e6 * p[1]}; };
  for (double size = 1; size > 1e-320; size /= 10)
    for (const double height : {1.0, 1e-8, 1e-9, 1e-10, 0.0})
      for (const double x : {0.0, 0.5, 1.2})
        addTriangle(input.triangles, {{{x, x}, {x + size, x}, {x, x + size * height}}}, toFar);
  addTriangle(input.triangles, {{{0.5, 0.5}, {0.5, 0.5 + 1e-300}, {0.7, 0.5}}}, unchanged);
  // Each is the first one where it is.
  const BakeTriangles all = input.triangles;
  for (std::size_t t = 0; t < all.count(); ++t) {
    input.triangles = {};
    const auto from = static_cast<std::ptrdiff_t>(6 * t);
    input.triangles.uv.assign(all.uv.begin() + from, all.uv.begin() + from + 6);
    input.triangles.oldUv.assign(all.oldUv.begin() + from, all.oldUv.begin() + from + 6);
    input.triangles.materials = {0};
    REQUIRE(baked(input, asLargeAs(texture)).bytes.size() == texture.bytes.size());
  }
}
