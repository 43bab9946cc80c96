#include "draw/band.h"

#include <cmath>
#include <random>

#include "catch.h"

using namespace abflat;

namespace {

constexpr int kSide = 40;
constexpr Rgb kBlack = {0, 0, 0}, kRed = {1, 0, 0};

/// Alpha values of the whole picture, 0 to 1, drawn in bands of a few rows.
template <class Draw>
std::vector<double> alphas(int bandRows, const Draw& draw) {
  std::vector<double> out;
  for (int first = 0; first < kSide; first += bandRows) {
    Band band(kSide, first, std::min(bandRows, kSide - first));
    draw(band);
    const std::vector<std::uint8_t> rgba = band.rgba({kBlack, 1, 1, kBlack});
    for (std::size_t i = 3; i < rgba.size(); i += 4) out.push_back(rgba[i] / 255.0);
  }
  return out;
}

double sumOf(const std::vector<double>& values) {
  double sum = 0;
  for (const double x : values) sum += x;
  return sum;
}

double areaOf(const std::vector<PixelPoint>& p) {
  double area = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const PixelPoint &a = p[i], &b = p[(i + 1) % p.size()];
    area += (a.x * b.y - a.y * b.x) / 2;
  }
  return std::abs(area);
}

}  // namespace

TEST_CASE("a polygon covers pixels by their exact shares, in bands of any height") {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(0, kSide);
  for (int i = 0; i < 200; ++i) {
    std::vector<PixelPoint> triangle;
    for (int k = 0; k < 3; ++k) triangle.push_back({coordinate(random), coordinate(random)});
    if (i % 3 == 0) triangle[1].x = triangle[0].x;
    if (i % 5 == 0) triangle[2] = {std::round(triangle[2].x), kSide};
    const auto draw = [&](Band& band) { band.fill(triangle, kRed); };
    const std::vector<double> whole = alphas(kSide, draw);
    // Each pixel is rounded to a multiple of 1/255.
    CHECK(sumOf(whole) == Approx(areaOf(triangle)).margin(0.5));
    CHECK(whole == alphas(7, draw));
  }
  const std::vector<PixelPoint> corner = {{4, 4}, {4.5, 4}, {4.5, 4.5}, {4, 4.5}};
  CHECK(alphas(kSide, [&](Band& band) { band.fill(corner, kRed); })[4 * kSide + 4] ==
        Approx(0.25).margin(0.003));
  // Not convex: an L that is three quarters of a square.
  const std::vector<PixelPoint> l = {{0, 0}, {8, 0}, {8, 4}, {4, 4}, {4, 8}, {0, 8}};
  const std::vector<double> cover = alphas(kSide, [&](Band& band) { band.fill(l, kRed); });
  CHECK(sumOf(cover) == Approx(48));
  CHECK(cover[6 * kSide + 6] == 0);
}

TEST_CASE("neighbours cover their common edge without a gap") {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> coordinate(1, kSide - 1);
  const std::vector<PixelPoint> square = {{0, 0}, {kSide, 0}, {kSide, kSide}, {0, kSide}};
  for (int i = 0; i < 50; ++i) {
    const PixelPoint middle{coordinate(random), coordinate(random)};
    const std::vector<double> cover = alphas(16, [&](Band& band) {
      for (std::size_t k = 0; k < 4; ++k) band.fill({square[k], square[(k + 1) % 4], middle}, kRed);
    });
    for (const double alpha : cover) REQUIRE(alpha == 1);
  }
}

TEST_CASE("lines have their width, and are no darker where they meet") {
  const auto line = [](double width) {
    return [=](Band& band) { band.draw(Band::Line::Thick, {10, 20.5}, {30, 20.5}, width); };
  };
  for (const double width : {1.0, 2.0, 3.5}) {
    const std::vector<double> cover = alphas(kSide, line(width));
    double across = 0;
    for (std::size_t y = 0; y < kSide; ++y) across += cover[y * kSide + 20];
    CHECK(across == Approx(width).margin(0.02));
    CHECK(cover == alphas(5, line(width)));
  }
  const auto twice = [&](Band& band) {
    line(1)(band);
    line(1)(band);
  };
  CHECK(alphas(kSide, line(1)) == alphas(kSide, twice));
}
