#include "islands/row_spans.h"

#include <array>

#include "catch.h"

using namespace abflat;

namespace {

constexpr std::array<double, 12> kSquare = {0, 0, 1, 0, 1, 1, 0, 0, 1, 1, 0, 1};

RowSpans spansOf(std::array<double, 12> square, double shiftU, double shiftV, double low,
                 double high) {
  for (std::size_t i = 0; i < square.size(); ++i) square[i] += i % 2 == 0 ? shiftU : shiftV;
  RowSpans out(low, high);
  out.cover(square.data(), 2);
  return out;
}

}  // namespace

TEST_CASE("row spans: a square covers its area, twice covered or not") {
  RowSpans once(0, 1);
  once.cover(kSquare.data(), 2);
  CHECK(once.area() == Approx(1));
  once.cover(kSquare.data(), 2);
  CHECK(once.area() == Approx(1));
}

TEST_CASE("row spans: triangles count either way round") {
  const double clockwise[] = {0, 0, 0, 1, 1, 0};
  RowSpans spans(0, 1);
  spans.cover(clockwise, 1);
  CHECK(spans.area() == Approx(0.5));
}

TEST_CASE("row spans: the common area of two squares") {
  const RowSpans a = spansOf(kSquare, 0, 0, 0, 1);
  CHECK(commonArea(a, spansOf(kSquare, 0.25, 0, 0, 1)) == Approx(0.75));
  CHECK(commonArea(a, spansOf(kSquare, 0.25, 0.5, 0, 1)) == Approx(0.375));
  CHECK(commonArea(a, spansOf(kSquare, 1, 0, 0, 1)) == 0);
}

TEST_CASE("row spans: nothing has area without height") {
  const double flat[] = {0, 1, 1, 1, 2, 1};
  RowSpans spans(1, 1);
  spans.cover(flat, 1);
  CHECK(spans.area() == 0);
}
