#include "abflat/pin_weights.h"

#include <cmath>
#include <complex>

#include "abflat/flatten.h"
#include "catch.h"
#include "support/meshes.h"

using namespace abflat;
using namespace abflat::test;

namespace {

using Complex = std::complex<double>;

/// A flattened mesh, in which every output vertex has the number of its input vertex.
PinnedMesh flat(const PolygonMesh& mesh, std::vector<std::uint32_t> pins) {
  Result<FlattenResult> r = flatten(mesh, {});
  INFO(r.status().message);
  REQUIRE(r.ok());
  return {mesh, std::move(r.value().uv), std::move(pins)};
}

std::vector<Complex> weightsOf(const PinnedMesh& layout) {
  const Result<std::vector<double>> r = pinWeights(layout);
  INFO(r.status().message);
  REQUIRE(r.ok());
  REQUIRE(r.value().size() == layout.uv.size());
  std::vector<Complex> out;
  for (std::size_t i = 0; i < r.value().size(); i += 2)
    out.emplace_back(r.value()[i], r.value()[i + 1]);
  return out;
}

Complex at(const std::vector<double>& uv, std::size_t v) { return {uv[2 * v], uv[2 * v + 1]}; }

/// A flat square grid with a square hole, which is not a disk.
PolygonMesh ring() {
  const PolygonMesh grid = bumpyGrid(9, 9, 0, 4);
  std::vector<std::uint32_t> number(grid.vertexCount(), kAnyFace), triangles;
  std::vector<double> positions;
  const auto numberOf = [&](std::uint32_t v) {
    if (number[v] != kAnyFace) return number[v];
    const double* p = &grid.positions[3 * std::size_t{v}];
    // Off the grid, so that no two triangles are alike.
    positions.insert(positions.end(), {p[0] + 0.2 * std::sin(v), p[1] + 0.2 * std::cos(v), 0});
    return number[v] = static_cast<std::uint32_t>(positions.size() / 3 - 1);
  };
  for (std::size_t f = 0; f < grid.faceCount(); ++f) {
    const auto isInside = [&](std::size_t k, std::size_t d) {
      const double x = grid.positions[3 * std::size_t{grid.faceVertices[3 * f + k]} + d];
      return x > 2.5 && x < 6.5;
    };
    if (isInside(0, 0) && isInside(0, 1)) continue;
    for (std::size_t k = 0; k < 3; ++k) triangles.push_back(numberOf(grid.faceVertices[3 * f + k]));
  }
  return makeTriangleMesh(positions, triangles);
}

/// Its own x and y as uv.
PinnedMesh seenFromAbove(const PolygonMesh& mesh, std::vector<std::uint32_t> pins) {
  PinnedMesh out{mesh, {}, std::move(pins)};
  for (std::size_t v = 0; v < mesh.vertexCount(); ++v)
    out.uv.insert(out.uv.end(), {mesh.positions[3 * v], mesh.positions[3 * v + 1]});
  return out;
}

}  // namespace

TEST_CASE("a single pin moves everything", "[pin]") {
  for (const Complex& w : weightsOf(flat(bumpyGrid(6, 5, 0.4, 3), {7})))
    CHECK(std::abs(w - 1.0) < 1e-12);
}

TEST_CASE("dragging one of two pins turns and scales about the other", "[pin]") {
  const PinnedMesh layout = flat(bumpyGrid(6, 5, 0.4, 3), {40, 2});
  const std::vector<Complex> weights = weightsOf(layout);
  const Complex still = at(layout.uv, 2), dragged = at(layout.uv, 40);
  for (std::size_t v = 0; v < weights.size(); ++v)
    CHECK(std::abs(weights[v] - (at(layout.uv, v) - still) / (dragged - still)) < 1e-12);
}

TEST_CASE("the dragged pin follows the pointer, and the others stay", "[pin]") {
  const std::vector<Complex> weights = weightsOf(flat(bumpyGrid(9, 9, 0.4, 8), {44, 0, 9, 90, 99}));
  CHECK(std::abs(weights[44] - 1.0) < 1e-12);
  for (const std::size_t v : {0, 9, 90, 99}) CHECK(std::abs(weights[v]) < 1e-12);
}

TEST_CASE("the weights of all pins add up to moving everything", "[pin]") {
  const std::vector<std::uint32_t> pins = {0, 50, 9, 95, 33};
  const PolygonMesh mesh = bumpyGrid(9, 9, 0.4, 8);
  std::vector<Complex> sum(mesh.vertexCount(), 0);
  for (const std::uint32_t first : pins) {
    std::vector<std::uint32_t> others = {first};
    for (const std::uint32_t p : pins)
      if (p != first) others.push_back(p);
    const std::vector<Complex> weights = weightsOf(flat(mesh, others));
    for (std::size_t v = 0; v < sum.size(); ++v) sum[v] += weights[v];
  }
  for (const Complex& w : sum) CHECK(std::abs(w - 1.0) < 1e-10);
}

TEST_CASE("a flat surface is moved with the least conformal energy, also around a hole", "[pin]") {
  const PolygonMesh mesh = ring();
  const std::vector<std::uint32_t> pins = {0, 20, 40, 60};
  const PinnedMesh layout = seenFromAbove(mesh, pins);
  const std::vector<Complex> weights = weightsOf(layout);
  // Where the energy is least, its derivative is 0: the sum over triangles of e_c, the functional
  // that vanishes for similar images, times the vertex's conjugate coefficient.
  std::vector<Complex> derivative(weights.size(), 0);
  double scale = 0;
  for (std::size_t f = 0; f < mesh.faceVertices.size(); f += 3) {
    const auto vertex = [&](std::size_t k) { return mesh.faceVertices[f + k % 3]; };
    const auto edge = [&](std::size_t k) {
      return at(layout.uv, vertex(k + 2)) - at(layout.uv, vertex(k + 1));
    };
    const double area = std::imag(std::conj(-edge(1)) * edge(2)) * -1;
    Complex e = 0;
    for (std::size_t k = 0; k < 3; ++k) e += edge(k) * weights[vertex(k)];
    for (std::size_t k = 0; k < 3; ++k) {
      const Complex part = e * std::conj(edge(k)) / std::abs(area);
      derivative[vertex(k)] += part;
      scale = std::max(scale, std::abs(part));
    }
  }
  CHECK(scale > 1e-3);
  for (const std::uint32_t v : pins) derivative[v] = 0;
  for (const Complex& d : derivative) CHECK(std::abs(d) < 1e-10 * scale);
}

TEST_CASE("weights do not depend on the scale of the surface or the place of the layout", "[pin]") {
  PinnedMesh layout = flat(bumpyGrid(8, 8, 0.5, 6), {0, 8, 80, 72, 40});
  const std::vector<Complex> weights = weightsOf(layout);
  const Complex turn = std::polar(0.01, 1.2);
  for (double& x : layout.mesh.positions) x *= 1e4;
  for (std::size_t v = 0; v < weights.size(); ++v) {
    const Complex to = turn * at(layout.uv, v) + Complex(0.3, 0.2);
    layout.uv[2 * v] = to.real();
    layout.uv[2 * v + 1] = to.imag();
  }
  const std::vector<Complex> other = weightsOf(layout);
  for (std::size_t v = 0; v < weights.size(); ++v) CHECK(std::abs(weights[v] - other[v]) < 1e-10);
}

TEST_CASE("triangles without area do not keep a pin from being dragged", "[pin]") {
  PolygonMesh mesh = bumpyGrid(6, 6, 0.2, 2);
  const PinnedMesh good = flat(mesh, {24, 0, 6, 48});
  PinnedMesh layout = good;
  for (std::size_t d = 0; d < 3; ++d)
    layout.mesh.positions[3 * 17 + d] = mesh.positions[3 * 16 + d];
  for (const Complex& w : weightsOf(layout)) CHECK(std::abs(w) < 4);
}

TEST_CASE("pins that cannot be dragged are refused", "[pin]") {
  const PinnedMesh good = flat(bumpyGrid(4, 4, 0.2, 2), {3, 7, 20});
  const auto message = [](const PinnedMesh& layout) {
    const Result<std::vector<double>> r = pinWeights(layout);
    CHECK(r.status().code == StatusCode::InvalidOption);
    return r.status().message;
  };
  const auto withPins = [&](std::vector<std::uint32_t> pins) {
    PinnedMesh out = good;
    out.pins = std::move(pins);
    return out;
  };
  using Catch::Contains;
  CHECK_THAT(message(withPins({})), Contains("no vertex is pinned"));
  CHECK_THAT(message(withPins({3, 25})), Contains("vertex 25") && Contains("25 vertices"));
  CHECK_THAT(message(withPins({3, 7, 3})), Contains("vertex 3 is pinned twice"));
  PinnedMesh layout = good;
  layout.uv.pop_back();
  CHECK_THAT(message(layout), Contains("uv has 49 numbers") && Contains("25 vertices"));
  layout = good;
  layout.uv[9] = NAN;
  CHECK_THAT(message(layout), Contains("vertex 4") && Contains("finite"));
  layout = good;
  for (const std::size_t v : {3, 7, 20}) layout.uv[2 * v] = layout.uv[2 * v + 1] = 0;
  CHECK_THAT(message(layout), Contains("at one place"));
}

TEST_CASE("a part that no pin holds does not disturb the others", "[pin]") {
  const PinnedMesh one = flat(bumpyGrid(4, 4, 0.2, 2), {3, 7, 20, 12});
  PinnedMesh two = one;
  const auto vertices = static_cast<std::uint32_t>(one.mesh.vertexCount());
  std::vector<double> positions = one.mesh.positions;
  for (const double x : one.mesh.positions) positions.push_back(x + 100);
  std::vector<std::uint32_t> triangles = one.mesh.faceVertices;
  for (const std::uint32_t v : one.mesh.faceVertices) triangles.push_back(v + vertices);
  two.mesh = makeTriangleMesh(positions, triangles);
  for (const double x : one.uv) two.uv.push_back(x + 100);
  const std::vector<Complex> alone = weightsOf(one), beside = weightsOf(two);
  for (std::size_t v = 0; v < alone.size(); ++v) CHECK(std::abs(beside[v] - alone[v]) < 1e-9);
  for (const Complex& w : beside) CHECK(std::isfinite(std::abs(w)));
}
