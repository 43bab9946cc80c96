#include "pack/cover.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "catch.h"
#include "pack/shapes.h"
#include "pack/texels.h"

using namespace abflat;
using namespace abflat::test;

namespace {

constexpr int kSide = 96;

/// A shape moved to some place in the grid.
PackShape inGrid(PackShape shape, unsigned seed) {
  const double size = 10.0 + seed % 17, x = 40 + 0.37 * (seed % 11), y = 41 + 0.61 * (seed % 13);
  for (std::size_t i = 0; i < shape.uv.size(); i += 2) {
    shape.uv[i] = x + size * shape.uv[i];
    shape.uv[i + 1] = y + size * shape.uv[i + 1];
  }
  return shape;
}

BitGrid covered(const PackShape& shape, double slack) {
  BitGrid grid;
  grid.reset(kSide, kSide);
  Cover().cover(coveringLoops(shape), slack, grid);
  return grid;
}

std::vector<PackShape> shapes() {
  std::vector<PackShape> out = makePackShapes("mixed", 200, 30, 3);
  for (unsigned i = 0; i < out.size(); ++i) out[i] = inGrid(out[i], i);
  return out;
}

int differences(const BitGrid& grid, const Texels& texels, int padding) {
  BitGrid expected;
  expected.reset(kSide, kSide);
  for (const auto& [x, y] : texels)
    for (int v = y - padding; v <= y + padding; ++v) expected.set(v, x - padding, x + padding);
  int count = 0;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) count += grid.at(x, y) != expected.at(x, y) ? 1 : 0;
  return count;
}

}  // namespace

TEST_CASE("cover marks just the cells that triangles touch", "[pack]") {
  for (const PackShape& shape : shapes()) {
    const Texels texels = touchedTexels(shape.uv, shape.triangles, 1);
    CHECK(differences(covered(shape, 1e-6), texels, 0) == 0);
    for (const int padding : {1, 2, 5})
      CHECK(differences(covered(shape, padding + 1e-6), texels, padding) == 0);
  }
}

TEST_CASE("cover goes without an outline", "[pack]") {
  for (PackShape shape : shapes()) {
    const Texels texels = touchedTexels(shape.uv, shape.triangles, 1);
    shape.outline.clear();
    CHECK(differences(covered(shape, 1e-6), texels, 0) == 0);
  }
}

TEST_CASE("cover leaves holes open", "[pack]") {
  // A ring within another ring.
  PackShape shape;
  constexpr std::uint32_t kSpokes = 24;
  const auto addRing = [&](double x, double y, double inner, double outer) {
    const auto first = static_cast<std::uint32_t>(shape.uv.size() / 2);
    for (std::uint32_t i = 0; i < kSpokes; ++i)
      for (const double radius : {inner, outer}) {
        const double angle = 2 * 3.14159265358979 * i / kSpokes;
        shape.uv.insert(shape.uv.end(),
                        {x + radius * std::cos(angle), y + radius * std::sin(angle)});
      }
    for (std::uint32_t i = 0; i < kSpokes; ++i) {
      const std::uint32_t a = first + 2 * i, b = first + 2 * ((i + 1) % kSpokes);
      shape.triangles.insert(shape.triangles.end(), {a, a + 1, b + 1, a, b + 1, b});
    }
  };
  addRing(40.3, 41.7, 12.2, 25.1);
  addRing(40.3, 41.7, 3.1, 7.4);
  const Texels texels = touchedTexels(shape.uv, shape.triangles, 1);
  CHECK(std::count(texels.begin(), texels.end(), std::pair(40, 41)) == 0);
  CHECK(differences(covered(shape, 1e-6), texels, 0) == 0);
}

TEST_CASE("cover includes triangles that are turned over", "[pack]") {
  // A fan that goes around its centre three times, and one whose centre is outside.
  for (const double x : {0.0, 25.0}) {
    PackShape shape;
    shape.uv = std::vector<double>{45.3 + x, 44.7};
    constexpr std::uint32_t kSpokes = 31;
    for (std::uint32_t i = 0; i < kSpokes; ++i) {
      const double angle = 6 * 3.14159265358979 * i / kSpokes;
      shape.uv.insert(shape.uv.end(), {45.3 + 20 * std::cos(angle), 44.7 + 20 * std::sin(angle)});
      shape.triangles.insert(shape.triangles.end(), {0, i + 1, (i + 1) % kSpokes + 1});
      shape.outline.push_back(i + 1);
    }
    const Texels texels = touchedTexels(shape.uv, shape.triangles, 1);
    CHECK(differences(covered(shape, 1e-6), texels, 0) == 0);
  }
}

TEST_CASE("edges on grid lines and nearly horizontal ones are covered", "[pack]") {
  for (const double tilt : {0.0, 1e-15, 1e-12, 1e-9, 1e-6, 1e-3})
    for (const double y : {10.0, 10.5, 11.0 - 1e-9}) {
      PackShape shape;
      shape.uv = std::vector<double>{5, y, 80, y + tilt, 80, y + 3};
      shape.triangles = shape.outline = {0, 1, 2};
      const Texels texels = touchedTexels(shape.uv, shape.triangles, 1);
      CHECK(differences(covered(shape, 1e-6), texels, 0) == 0);
    }
}

TEST_CASE("transposed, columns are rows", "[pack]") {
  for (const auto& [width, height] : {std::pair(1, 1), std::pair(64, 3), std::pair(65, 130)}) {
    BitGrid grid, turned;
    grid.reset(width, height);
    for (int y = 0; y < height; ++y)
      for (int x = y % 3; x < width; x += 1 + (x * y) % 7) grid.set(y, x, x);
    transpose(grid, turned);
    REQUIRE(turned.width == height);
    REQUIRE(turned.height == width);
    int wrong = 0;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) wrong += grid.at(x, y) != turned.at(y, x) ? 1 : 0;
    CHECK(wrong == 0);
  }
}

TEST_CASE("a halved grid has what any of four cells has", "[pack]") {
  std::mt19937 random(5);
  for (const int size : {2, 65, 131}) {
    BitGrid grid;
    grid.reset(size, size);
    for (int k = 0; k < size * size / 3; ++k) {
      const int x = static_cast<int>(random() % static_cast<unsigned>(size));
      grid.set(static_cast<int>(random() % static_cast<unsigned>(size)), x, x);
    }
    const BitGrid half = halved(grid);
    REQUIRE(half.width == size / 2);
    REQUIRE(half.height == size / 2);
    double count = 0;
    for (int y = 0; y < size / 2; ++y)
      for (int x = 0; x < size / 2; ++x) {
        const bool isAny = grid.at(2 * x, 2 * y) || grid.at(2 * x + 1, 2 * y) ||
                           grid.at(2 * x, 2 * y + 1) || grid.at(2 * x + 1, 2 * y + 1);
        CHECK(half.at(x, y) == isAny);
        count += isAny ? 1 : 0;
      }
    CHECK(countCells(half) == count);
  }
  CHECK(halved({}).words.empty());
}

TEST_CASE("grids are added cell by cell", "[pack]") {
  BitGrid one, other, sum;
  one.reset(70, 2);
  one.set(0, 3, 66);
  other.reset(70, 2);
  other.set(0, 66, 69);
  other.set(1, 0, 0);
  add(one, sum);
  CHECK(countCells(sum) == 64);
  add(other, sum);
  CHECK(countCells(sum) == 68);
  CHECK(sum.at(0, 1));
  CHECK_FALSE(sum.at(2, 0));
}

TEST_CASE("runs are the cells of a grid", "[pack]") {
  for (const PackShape& shape : shapes()) {
    const BitGrid grid = covered(shape, 0.1);
    std::vector<Run> runs;
    appendRuns(grid, runs);
    BitGrid again;
    again.reset(kSide, kSide);
    for (const Run& run : runs) {
      CHECK((run.first == 0 || !grid.at(run.first - 1, run.row)));
      CHECK((run.last == kSide - 1 || !grid.at(run.last + 1, run.row)));
      again.set(run.row, run.first, run.last);
    }
    CHECK(again.words == grid.words);
  }
}
