#include "abflat/tangents.h"

#include <array>
#include <cmath>
#include <numeric>
#include <random>

#include "catch.h"
#include "mesh/vec3_sum.h"

using namespace abflat;

namespace {

/// A bumpy sphere of 2 n^2 triangles without its poles; u goes around, v down.
TangentInput sphere(int n) {
  TangentInput out;
  const auto add = [&](int i, int j) {
    const double u = 1.0 * i / n, v = 1.0 * j / n;
    const double east = 6.28 * u, south = 0.3 + 2.5 * v;
    const Vec3 p = {std::sin(south) * std::cos(east), std::cos(south),
                    -std::sin(south) * std::sin(east)};
    const double bump = 1 + 0.1 * std::sin(5 * east) * std::cos(7 * south);
    for (const double x : p) out.positions.push_back(bump * x);
    for (const double x : p) out.normals.push_back(static_cast<float>(x));
    out.uv.insert(out.uv.end(), {u, v});
  };
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i)
      for (const auto& [di, dj] : {std::array{0, 0}, {0, 1}, {1, 1}, {0, 0}, {1, 1}, {1, 0}})
        add(i + di, j + dj);
  return out;
}

/// The corners of the input in another order.
TangentInput taken(const TangentInput& input, const std::vector<std::size_t>& corners) {
  TangentInput out;
  for (const std::size_t c : corners) {
    for (std::size_t d = 0; d < 3; ++d) {
      out.positions.push_back(input.positions[3 * c + d]);
      out.normals.push_back(input.normals[3 * c + d]);
    }
    for (std::size_t d = 0; d < 2; ++d) out.uv.push_back(input.uv[2 * c + d]);
  }
  return out;
}

Vec3 vectorAt(const std::vector<float>& values, std::size_t stride, std::size_t c) {
  return {values[stride * c], values[stride * c + 1], values[stride * c + 2]};
}

}  // namespace

TEST_CASE("tangents are unit vectors across the normal that point to where u grows") {
  const TangentInput input = sphere(12);
  const std::vector<float> tangents = mikkTangents(input);
  REQUIRE(tangents.size() == 2 * input.uv.size());
  for (std::size_t c = 0; c < tangents.size() / 4; ++c) {
    const Vec3 t = vectorAt(tangents, 4, c), n = vectorAt(input.normals, 3, c);
    REQUIRE(norm(t) == Approx(1));
    REQUIRE(dot(t, n) == Approx(0).margin(1e-6));
    const double east = 6.28 * input.uv[2 * c];
    CHECK(dot(t, {-std::sin(east), 0, -std::cos(east)}) > 0.9);
    // The bitangent points up, where v is smaller.
    REQUIRE(tangents[4 * c + 3] == 1);
    REQUIRE(cross(n, t)[1] >= 0);
  }
}

TEST_CASE("mirrored uv turn the sign, and mirrored neighbours have tangents of their own") {
  TangentInput input = sphere(6);
  const std::vector<float> before = mikkTangents(input);
  for (std::size_t i = 0; i < input.uv.size(); i += 2) input.uv[i] *= -1;
  const std::vector<float> after = mikkTangents(input);
  for (std::size_t i = 0; i < before.size(); ++i) REQUIRE(after[i] == Approx(-before[i]));

  // Two squares that share an edge on the line u = 0, mirrored there.
  TangentInput pair;
  const std::array<std::array<double, 2>, 4> square = {
      std::array{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}};
  for (const double side : {1.0, -1.0})
    for (const std::size_t k : {0, 1, 2, 0, 2, 3}) {
      const auto [x, y] = square[side < 0 ? 3 - k : k];  // counter-clockwise
      pair.positions.insert(pair.positions.end(), {side * x, y, 0});
      pair.normals.insert(pair.normals.end(), {0, 0, 1});
      pair.uv.insert(pair.uv.end(), {x, -y});
    }
  const std::vector<float> tangents = mikkTangents(pair);
  for (std::size_t c = 0; c < 12; ++c) {
    const float sign = c < 6 ? 1 : -1;
    CHECK(tangents[4 * c] == Approx(sign));
    CHECK(tangents[4 * c + 3] == sign);
  }
}

TEST_CASE("tangents do not depend on the order of faces and corners") {
  const TangentInput input = sphere(9);
  const std::vector<float> tangents = mikkTangents(input);
  std::mt19937 random(3);
  std::vector<std::size_t> faces(input.uv.size() / 6);
  std::iota(faces.begin(), faces.end(), std::size_t{0});
  std::shuffle(faces.begin(), faces.end(), random);
  std::vector<std::size_t> corners;
  for (const std::size_t f : faces)
    for (std::size_t k = 0; k < 3; ++k) corners.push_back(3 * f + (k + f) % 3);
  const std::vector<float> shuffled = mikkTangents(taken(input, corners));
  for (std::size_t c = 0; c < corners.size(); ++c)
    for (std::size_t d = 0; d < 4; ++d)
      REQUIRE(shuffled[4 * c + d] == Approx(tangents[4 * corners[c] + d]).margin(1e-6));
}

TEST_CASE("corners in one place have one tangent, weighted by angles") {
  // A right angle and two small ones of a fan around the origin, of which u grows differently.
  TangentInput fan;
  const std::array<Vec3, 4> rim = {Vec3{1, 0, 0}, {0, 1, 0}, {-0.1, 1, 0}, {-0.2, 1, 0}};
  const std::array<std::array<double, 2>, 4> uv = {
      std::array{1.0, 0.0}, {0.0, -1.0}, {-0.3, -1.0}, {-0.8, -1.0}};
  for (std::size_t k = 0; k < 3; ++k)
    for (int corner = 0; corner < 3; ++corner) {
      const std::size_t at = corner == 1 ? k : k + 1;
      const Vec3 p = corner == 0 ? Vec3{} : rim[at];
      fan.positions.insert(fan.positions.end(), p.begin(), p.end());
      fan.normals.insert(fan.normals.end(), {0, 0, 1});
      fan.uv.insert(fan.uv.end(), {corner == 0 ? 0 : uv[at][0], corner == 0 ? 0 : uv[at][1]});
    }
  const std::vector<float> tangents = mikkTangents(fan);
  Vec3 expected{};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto& a = uv[k];
    const auto& b = uv[k + 1];
    const double area = a[0] * b[1] - b[0] * a[1];
    const Vec3 along = sum(sum(Vec3{}, rim[k], b[1] / area), rim[k + 1], -a[1] / area);
    expected = sum(expected, unit(along), std::acos(dot(unit(rim[k]), unit(rim[k + 1]))));
  }
  expected = unit(expected);
  for (const std::size_t c : {0, 3, 6})
    for (std::size_t d = 0; d < 3; ++d)
      CHECK(tangents[4 * c + d] == Approx(expected[d]).margin(1e-6));
}

TEST_CASE("faces without area take the tangents of their neighbours") {
  TangentInput input = sphere(4);
  const std::vector<float> before = mikkTangents(input);
  std::vector<std::size_t> corners(input.uv.size() / 2);
  std::iota(corners.begin(), corners.end(), std::size_t{0});
  const std::size_t first = corners.size();
  corners.insert(corners.begin(), {7, 7, 8});
  const std::vector<float> after = mikkTangents(taken(input, corners));
  for (std::size_t c = 0; c < corners.size(); ++c)
    for (std::size_t d = 0; d < 4; ++d)
      REQUIRE(after[4 * c + d] == Approx(before[4 * corners[c] + d]));
  REQUIRE(first + 3 == corners.size());

  // On its own, any tangent across the normal.
  TangentInput alone;
  alone.positions.assign(9, 1);
  alone.uv.assign(6, 0);
  for (int k = 0; k < 3; ++k) alone.normals.insert(alone.normals.end(), {0, 1, 0});
  const std::vector<float> tangents = mikkTangents(alone);
  for (std::size_t c = 0; c < 3; ++c) {
    CHECK(norm(vectorAt(tangents, 4, c)) == Approx(1));
    CHECK(tangents[4 * c + 1] == 0);
  }
}
