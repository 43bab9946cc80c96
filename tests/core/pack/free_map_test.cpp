#include "pack/free_map.h"

#include <random>

#include "catch.h"

using namespace abflat;

namespace {

/// Blots of random cells, some of them with gaps.
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

/// Counts the free cells by taking them one after the other.
double countFree(FreeMap map) {
  BitGrid dot;
  dot.reset(1, 1);
  dot.set(0, 0, 0);
  Footprint footprint;
  footprint.set(dot);
  double count = 0;
  for (int y = 0; y < map.height(); ++y)
    for (Cell cell; (cell = map.find(footprint, y, y + 1)).isFound(); ++count)
      map.take(dot, cell.x, cell.y);
  return count;
}

}  // namespace

TEST_CASE("the free map finds the first free place", "[pack]") {
  std::mt19937 random(5);
  int found = 0;
  for (const int width : {1, 7, 63, 64, 65, 100, 128, 200}) {
    const int height = 40 + static_cast<int>(random() % 30);
    FreeMap map;
    map.reset(width, height, width);
    BitGrid taken;
    taken.reset(width, height);
    Footprint footprint;
    for (int k = 0; k < 60; ++k) {
      const BitGrid shape = randomGrid(random, 3 + static_cast<int>(random() % 70));
      footprint.set(shape);
      const int begin = static_cast<int>(random() % 5);
      const int end = begin + static_cast<int>(random() % static_cast<unsigned>(height));
      const Cell cell = map.find(footprint, begin, end);
      const Cell expected = firstFree(taken, shape, begin, end);
      REQUIRE(cell.x == expected.x);
      REQUIRE(cell.y == expected.y);
      // Also where nothing was found: taking cells twice, or outside, does no harm.
      const Cell at = cell.isFound() ? cell
                                     : Cell{static_cast<int>(random() % 60) - 30,
                                            static_cast<int>(random() % 60) - 30};
      found += cell.isFound() ? 1 : 0;
      map.take(shape, at.x, at.y);
      for (int v = 0; v < shape.height; ++v)
        for (int u = 0; u < shape.width; ++u)
          if (shape.at(u, v)) taken.set(at.y + v, at.x + u, at.x + u);
      REQUIRE(countFree(map) == static_cast<double>(width) * height - countCells(taken));
    }
  }
  CHECK(found > 100);
}

TEST_CASE("an empty or too large footprint has no place", "[pack]") {
  FreeMap map;
  map.reset(20, 10, 20);
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

TEST_CASE("a map limited to ever shorter runs finds what one for all runs finds", "[pack]") {
  std::mt19937 random(9);
  FreeMap whole, limited;
  whole.reset(150, 60, 150);
  limited.reset(150, 60, 150);
  Footprint footprint;
  for (const int longest : {60, 33, 17, 16, 5, 1}) {
    limited.limit(longest);
    if (longest == 16) limited.shrink();
    int found = 0;
    for (int k = 0; k < 30; ++k) {
      const BitGrid shape = randomGrid(random, longest);
      footprint.set(shape);
      const Cell cell = whole.find(footprint, 0, 60), other = limited.find(footprint, 0, 60);
      REQUIRE(cell.x == other.x);
      REQUIRE(cell.y == other.y);
      if (!cell.isFound()) continue;
      ++found;
      whole.take(shape, cell.x, cell.y);
      limited.take(shape, cell.x, cell.y);
    }
    CHECK(found > 0);
  }
}

TEST_CASE("a map for short runs finds what one for all runs finds", "[pack]") {
  std::mt19937 random(8);
  for (const int longest : {1, 5, 16, 33}) {
    FreeMap whole, shorter;
    whole.reset(150, 60, 150);
    shorter.reset(150, 60, longest);
    Footprint footprint;
    int found = 0;
    for (int k = 0; k < 80; ++k) {
      const BitGrid shape = randomGrid(random, longest);
      footprint.set(shape);
      const Cell cell = whole.find(footprint, 0, 60), other = shorter.find(footprint, 0, 60);
      REQUIRE(cell.x == other.x);
      REQUIRE(cell.y == other.y);
      if (!cell.isFound()) continue;
      ++found;
      whole.take(shape, cell.x, cell.y);
      shorter.take(shape, cell.x, cell.y);
    }
    CHECK(found > 10);
  }
}
