#include "pack/quick_fit.h"

#include <algorithm>
#include <random>
#include <vector>

#include "catch.h"

using namespace abflat;

namespace {

using Outline = std::vector<PlanePoint>;

Outline box(double width, double height) {
  return {{0, 0}, {width, 0}, {width, height}, {0, height}};
}

/// Boxes with sides from 0.2 to 1.
std::vector<Outline> boxes(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  const auto side = [&] { return 0.2 + 0.8 * static_cast<double>(random() % 1000) / 1000; };
  std::vector<Outline> out;
  for (std::size_t i = 0; i < count; ++i) {
    const double width = side();
    out.push_back(box(width, side()));
  }
  return out;
}

QuickFit fitOf(const std::vector<Outline>& outlines) {
  PackOptions options;
  options.rotate = Rotate::Free;
  QuickFit out(options, 96);
  for (const Outline& outline : outlines) out.add(out.itemOf(outline));
  return out;
}

}  // namespace

TEST_CASE("items that are held have the places that they have otherwise", "[pack]") {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const std::vector<Outline> all = boxes(12, seed);
    QuickFit held = fitOf(all);
    const double side = 0.8 * held.leastSide();
    for (std::uint32_t cut = 0; cut < all.size(); ++cut) {
      held.hold(side, {cut});
      // The parts that a cut leaves of an item are smaller.
      const double width = all[cut][2].x / 3, height = all[cut][2].y;
      std::vector<Outline> parts = all;
      parts[cut] = box(2 * width, height);
      parts.push_back(box(width, height));
      PackItem whole = held.exchange(cut, held.itemOf(parts[cut]));
      held.add(held.itemOf(parts.back()));
      CHECK(held.placed(side) == fitOf(parts).placed(side));
      held.removeLast();
      held.exchange(cut, std::move(whole));
      held.release();
    }
  }
}

TEST_CASE("placing ends where more than a given area has no place, and not before", "[pack]") {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    QuickFit fit = fitOf(boxes(12, seed));
    const double side = 0.7 * fit.leastSide();
    const auto missing = [&](const std::vector<std::uint8_t>& isPlaced) {
      double sum = 0;
      for (std::size_t i = 0; i < isPlaced.size(); ++i)
        if (!isPlaced[i]) sum += fit.items()[i].mass.area;
      return sum;
    };
    const std::vector<std::uint8_t> all = fit.placed(side);
    const double area = missing(all);
    REQUIRE(area > 0);
    CHECK(fit.placed(side, 1.001 * area) == all);
    CHECK(missing(fit.placed(side, 0.5 * area)) > 0.5 * area);
  }
}
