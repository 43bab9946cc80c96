#include "pin/pinned_layout.h"

#include <cmath>
#include <complex>

#include "abflat/flatten.h"
#include "catch.h"
#include "support/instrumented.h"
#include "support/meshes.h"

using namespace abflat;
using namespace abflat::test;

namespace {

using Complex = std::complex<double>;

Result<FlattenResult> flattened(const PolygonMesh& mesh, const std::vector<Pin>& pins,
                                double t = 2) {
  FlattenOptions options;
  options.t = t;
  options.pins = pins;
  return flatten(mesh, options);
}

FlattenResult pinned(const PolygonMesh& mesh, const std::vector<Pin>& pins, double t = 2) {
  Result<FlattenResult> r = flattened(mesh, pins, t);
  INFO(r.status().message);
  REQUIRE(r.ok());
  return std::move(r.value());
}

/// In these meshes every output vertex has the number of its input vertex.
Complex at(const FlattenResult& r, std::uint32_t v) {
  return {r.uv[2 * std::size_t{v}], r.uv[2 * std::size_t{v} + 1]};
}

Pin pinAt(std::uint32_t vertex, Complex uv) { return {vertex, {uv.real(), uv.imag()}}; }

double largestDifference(const std::vector<double>& a, const std::vector<double>& b) {
  REQUIRE(a.size() == b.size());
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
  return most;
}

}  // namespace

TEST_CASE("two pins turn, scale and move the layout, and do not mirror it", "[pin]") {
  const PolygonMesh mesh = bumpyGrid(9, 7, 0.4, 3);
  const FlattenResult free = pinned(mesh, {});
  const Complex p{-3.25, 17.5}, q{0.125, 1e-3};
  const FlattenResult r = pinned(mesh, {pinAt(4, p), pinAt(60, q)});
  CHECK(r.report.valid);
  CHECK(at(r, 4) == p);
  CHECK(at(r, 60) == q);
  const Complex factor = (q - p) / (at(free, 60) - at(free, 4));
  for (std::uint32_t v = 0; v < mesh.vertexCount(); ++v)
    CHECK(std::abs(at(r, v) - (p + factor * (at(free, v) - at(free, 4)))) < 1e-12 * std::abs(p));
  CHECK(r.report.charts[0].angularDistortion ==
        Approx(free.report.charts[0].angularDistortion).epsilon(1e-9));
  REQUIRE(r.report.charts[0].pins);
  CHECK(r.report.charts[0].pins->count == 2);
  CHECK(r.report.charts[0].pins->deviation == 0);
  CHECK_FALSE(free.report.charts[0].pins);
}

TEST_CASE("pins that agree with the layout reproduce it", "[pin]") {
  for (const double t : {1.0, 2.0}) {
    const PolygonMesh mesh = bumpyGrid(15, 12, 0.6, 5);
    const FlattenResult free = pinned(mesh, {}, t);
    std::vector<Pin> pins;
    for (std::uint32_t v = 3; v < mesh.vertexCount(); v += 20)
      pins.push_back(pinAt(v, at(free, v)));
    const FlattenResult r = pinned(mesh, pins, t);
    CHECK(largestDifference(r.uv, free.uv) < 1e-9);
    CHECK(r.report.charts[0].pins->deviation < 1e-12);
  }
}

TEST_CASE("more pins are met exactly, with the least conformal energy", "[pin]") {
  const PolygonMesh mesh = bumpyGrid(10, 10, 0, 1);
  const FlattenResult free = pinned(mesh, {});
  constexpr double side = 10;
  const std::vector<std::uint32_t> corners = {0, 10, 120, 110};
  std::vector<Pin> pins;
  for (const std::uint32_t v : corners) pins.push_back(pinAt(v, at(free, v)));
  pins[1].uv[0] += 0.05 * side;
  pins[2].uv[1] -= 0.03 * side;
  const FlattenResult r = pinned(mesh, pins);
  CHECK(r.report.valid);
  CHECK(r.report.charts[0].pins->deviation > 0);
  for (const Pin& p : pins) CHECK(at(r, p.vertex) == Complex(p.uv[0], p.uv[1]));
  // Where the energy is least, its derivative is 0: the sum over triangles of e_c, the functional
  // of a flat triangle that vanishes for its similar images, times the vertex's conjugate
  // coefficient.
  std::vector<Complex> derivative(mesh.vertexCount(), 0);
  double scale = 0;
  for (std::size_t f = 0; f < r.triangles.size(); f += 3) {
    const auto corner = [&](const FlattenResult& of, std::size_t k) {
      return at(of, r.triangles[f + k % 3]);
    };
    const Complex x = corner(free, 1) - corner(free, 0), y = corner(free, 2) - corner(free, 0);
    const double area = std::imag(std::conj(x) * y);
    Complex e = 0;
    for (std::size_t k = 0; k < 3; ++k)
      e += (corner(free, k + 2) - corner(free, k + 1)) * corner(r, k) / std::sqrt(area);
    for (std::size_t k = 0; k < 3; ++k) {
      const Complex part =
          e * std::conj(corner(free, k + 2) - corner(free, k + 1)) / std::sqrt(area);
      derivative[r.triangles[f + k]] += part;
      scale = std::max(scale, std::abs(part));
    }
  }
  CHECK(scale > 1e-3);
  for (const std::uint32_t v : corners) derivative[v] = 0;
  for (const Complex& d : derivative) CHECK(std::abs(d) < 1e-10 * scale);
}

TEST_CASE("a pinned layout does not depend on the numbering", "[pin]") {
  const PolygonMesh mesh = bumpyGrid(8, 8, 0.5, 9);
  const Renumbered other = renumbered(mesh, 4);
  std::vector<Pin> pins = {{0, {0, 0}}, {8, {7.5, 0.5}}, {80, {8, 9}}, {40, {4, 4.5}}}, moved;
  for (const Pin& p : pins) moved.push_back({other.vertex[p.vertex], p.uv});
  const FlattenResult a = pinned(mesh, pins), b = pinned(other.mesh, moved);
  for (std::size_t c = 0; c < mesh.faceVertices.size(); ++c)
    CHECK(std::abs(at(a, a.cornerUv[c]) - at(b, b.cornerUv[other.corner[c]])) < 1e-9);
}

TEST_CASE("pins that fold the layout are met all the same, and reported", "[pin]") {
  const PolygonMesh mesh = bumpyGrid(6, 6, 0.2, 2);
  const FlattenResult free = pinned(mesh, {});
  // Two corners of the square swap places.
  std::vector<Pin> pins;
  for (const std::uint32_t v : {0u, 6u, 48u}) pins.push_back(pinAt(v, at(free, v)));
  std::swap(pins[1].uv, pins[2].uv);
  pins.push_back(pinAt(42, at(free, 42)));
  const FlattenResult r = pinned(mesh, pins);
  CHECK_FALSE(r.report.valid);
  CHECK(r.report.charts[0].problem.find("the pins fold the layout") == 0);
  CHECK(r.report.charts[0].flippedTriangles + r.report.charts[0].boundaryCrossings > 0);
  for (const Pin& p : pins) CHECK(at(r, p.vertex) == Complex(p.uv[0], p.uv[1]));
}

TEST_CASE("pins keep to the memory that is allowed", "[pin]") {
  for (const double jitter : {0.0, 0.5}) {
    if (kIsInstrumented && jitter == 0) continue;
    const std::uint32_t n = 120;
    const PolygonMesh mesh = bumpyGrid(n, n, jitter, 7);
    FlattenOptions options;
    options.t = 2;
    options.pins = {pinAt(0, {0, 0}), pinAt(n, {130, 4}), pinAt((n + 1) * n, {-3, 125}),
                    pinAt((n + 1) * 40 + 31, {34, 50})};
    const Result<FlattenResult> usual = flatten(mesh, options);
    REQUIRE(usual.ok());
    CHECK(usual.value().report.charts[0].fallbacks.empty());
    for (const double memory : {12.0, 8.0, 0.5}) {
      if (kIsInstrumented && memory == 8) continue;
      options.memory = memory;
      const Result<FlattenResult> limited = flatten(mesh, options);
      REQUIRE(limited.ok());
      // In a layout about 130 wide.
      CHECK(largestDifference(limited.value().uv, usual.value().uv) < 1e-7);
      const std::vector<std::string>& notes = limited.value().report.charts[0].fallbacks;
      REQUIRE(notes.size() == 2);
      CHECK_THAT(notes[1], Catch::StartsWith("pins: factoring the matrix needs ") &&
                               Catch::Contains(memory > 10 ? "single precision" : "multigrid"));
      CHECK(limited.value().report.valid == usual.value().report.valid);
    }
  }
}

TEST_CASE("pins that make no sense are named", "[pin]") {
  PolygonMesh mesh = bumpyGrid(4, 4, 0.2, 2);
  mesh.positions.insert(mesh.positions.end(), {0, 0, 0});
  const auto message = [&](const std::vector<Pin>& pins) {
    const Result<FlattenResult> r = flattened(mesh, pins);
    CHECK(r.status().code == StatusCode::InvalidOption);
    return r.status().message;
  };
  using Catch::Contains;
  CHECK_THAT(message({{3, {0, 0}}}), Contains("vertex 3 is the only pinned vertex"));
  CHECK_THAT(message({{3, {0, 0}}, {99, {1, 0}}}),
             Contains("vertex 99") && Contains("26 vertices"));
  CHECK_THAT(message({{3, {0, 0}}, {25, {1, 0}}}),
             Contains("vertex 25") && Contains("no flattened face"));
  CHECK_THAT(message({{3, {0, 0}}, {3, {1, 0}}}), Contains("vertex 3 is pinned twice"));
  CHECK_THAT(message({{3, {0, 0}}, {7, {1, 0}}, {9, {0, 0}}}), Contains("vertices 3 and 9"));
  CHECK_THAT(message({{3, {0, NAN}}, {7, {1, 0}}}), Contains("vertex 3") && Contains("finite"));
  CHECK_THAT(message({{3, {0, 0}}, {0, {1, 0}, 31}}), Contains("face 31, which does not use it"));
}
