#include "pack/free_map.h"

#include <random>

#include "catch.h"

using namespace abflat;

namespace {

/// Blots of random cells, some with gaps.
BitGrid randomGrid(std::mt19937& random, int most) {
  BitGrid grid;
  const auto size = [&] { return 1 + static_cast<int>(random() % static_cast<unsigned>(most)); };
  grid.reset(size(), size());
  for (int y = 0; y < grid.height; ++y)
    for (int k = 0; k < 2; ++k) {
      const int first = static_cast<int>(random() % static_cast<unsigned>(grid.width));
      grid.set(y, first, first + size() / 2);
    }
  grid.set(0, 0, 0);
  return grid;
}

bool isFree(const BitGrid& taken, const BitGrid& shape, int x, int y) {
  for (int v = 0; v < shape.height; ++v)
    for (int u = 0; u < shape.width; ++u)
      if (shape.at(u, v) && taken.at(x + u, y + v)) return false;
  return true;
}

Cell firstFree(const BitGrid& taken, const BitGrid& shape, int begin, int end) {
  for (int y = begin; y < end && y + shape.height <= taken.height; ++y)
    for (int x = 0; x + shape.width <= taken.width; ++x)
      if (isFree(taken, shape, x, y)) return {x, y};
  return {};
}

}  // namespace

TEST_CASE("the free map finds the first free place", "[pack]") {
  std::mt19937 random(5);
  for (const int width : {1, 7, 63, 64, 65, 100, 128, 200}) {
    const int height = 40 + static_cast<int>(random() % 30);
    FreeMap map(width, height);
    BitGrid taken;
    taken.reset(width, height);
    Footprint footprint;
    double count = width * height;
    int found = 0;
    for (int k = 0; k < 60; ++k) {
      const BitGrid shape = randomGrid(random, 3 + static_cast<int>(random() % 70));
      footprint.set(shape);
      const int begin = static_cast<int>(random() % 5);
      const int end = begin + static_cast<int>(random() % static_cast<unsigned>(height));
      const Cell cell = map.find(footprint, begin, end);
      const Cell expected = firstFree(taken, shape, begin, end);
      REQUIRE(cell.x == expected.x);
      REQUIRE(cell.y == expected.y);
      // Also where nobody looked: what is taken twice or outside does not matter.
      const Cell at = cell.isFound() ? cell
                                     : Cell{static_cast<int>(random() % 60) - 30,
                                            static_cast<int>(random() % 60) - 30};
      found += cell.isFound() ? 1 : 0;
      map.take(shape, at.x, at.y);
      for (int v = 0; v < shape.height; ++v)
        for (int u = 0; u < shape.width; ++u)
          if (shape.at(u, v)) taken.set(at.y + v, at.x + u, at.x + u);
      count = 0;
      for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) count += taken.at(x, y) ? 0 : 1;
      REQUIRE(map.freeCells() == count);
    }
    CHECK(found > 0);
  }
}

TEST_CASE("an empty or too large footprint has no place", "[pack]") {
  FreeMap map(20, 10);
  Footprint footprint;
  BitGrid grid;
  grid.reset(5, 5);
  footprint.set(grid);
  CHECK_FALSE(map.find(footprint, 0, 10).isFound());
  grid.reset(21, 1);
  grid.set(0, 0, 20);
  footprint.set(grid);
  CHECK_FALSE(map.find(footprint, 0, 10).isFound());
  grid.reset(20, 10);
  for (int y = 0; y < 10; ++y) grid.set(y, 0, 19);
  footprint.set(grid);
  CHECK(map.find(footprint, 0, 10).isFound());
  map.take(grid, 0, 9);
  CHECK_FALSE(map.find(footprint, 0, 10).isFound());
}

TEST_CASE("a halved map is free where all four cells are", "[pack]") {
  std::mt19937 random(5);
  for (const int size : {2, 65, 131}) {
    FreeMap map(size, size);
    BitGrid taken;
    taken.reset(size, size);
    for (int k = 0; k < 4; ++k) {
      const BitGrid blot = randomGrid(random, size);
      const int x = static_cast<int>(random() % static_cast<unsigned>(size));
      map.take(blot, x, 0);
      for (int v = 0; v < std::min(blot.height, size); ++v)
        for (int u = 0; u < blot.width; ++u)
          if (blot.at(u, v)) taken.set(v, x + u, x + u);
    }
    const FreeMap half = map.halved();
    REQUIRE(half.width() == size / 2);
    BitGrid square;
    square.reset(2, 2);
    for (int y = 0; y < 2; ++y) square.set(y, 0, 1);
    double free = 0;
    for (int y = 0; y < size / 2; ++y)
      for (int x = 0; x < size / 2; ++x) {
        const bool isSquareFree = isFree(taken, square, 2 * x, 2 * y);
        CHECK(half.isFree(x, y) == isSquareFree);
        free += isSquareFree ? 1 : 0;
      }
    CHECK(half.freeCells() == free);
  }
}
