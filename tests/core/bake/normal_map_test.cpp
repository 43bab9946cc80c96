#include <algorithm>
#include <cmath>

#include "abflat/tangents.h"
#include "bake/baked.h"
#include "base/constants.h"
#include "mesh/vec3_sum.h"

using namespace abflat;
using test::addQuad;
using test::asLargeAs;
using test::baked;
using test::centreOf;
using test::Image;
using test::unchanged;

namespace {

double asCoordinate(int number) { return 2 * number / 255.0 - 1; }

/// Gentle waves, as unit vectors.
Image waves(std::uint32_t side) {
  Image out(side, side, 3);
  for (std::size_t y = 0; y < side; ++y)
    for (std::size_t x = 0; x < side; ++x) {
      const Point2 p = centreOf(x, y);
      const Vec3 n = unit({0.6 * std::sin(p[0] / 20), 0.5 * std::cos(p[1] / 17 + p[0] / 30), 1});
      for (int d = 0; d < 3; ++d)
        out.set(x, y, d,
                static_cast<int>(std::lround((n[static_cast<std::size_t>(d)] + 1) * 127.5)));
    }
  return out;
}

Vec3 vectorIn(const Image& map, std::size_t x, std::size_t y) {
  return {asCoordinate(map.at(x, y, 0)), asCoordinate(map.at(x, y, 1)),
          asCoordinate(map.at(x, y, 2))};
}

/// What a renderer makes of a vector at a corner's frame.
Vec3 lit(const Vec3& vector, const Vec3& normal, const float* tangent) {
  const Vec3 t = {tangent[0], tangent[1], tangent[2]}, b = cross(normal, t);
  Vec3 out{};
  for (std::size_t d = 0; d < 3; ++d)
    out[d] = vector[0] * t[d] + vector[1] * tangent[3] * b[d] + vector[2] * normal[d];
  return unit(out);
}

/// Makes triangles clockwise in their old uv, so that with y = -v they are seen from z > 0.
void faceForward(BakeTriangles& triangles) {
  for (std::size_t t = 0; t < triangles.count(); ++t) {
    const double* const p = &triangles.oldUv[6 * t];
    if ((p[2] - p[0]) * (p[5] - p[1]) < (p[3] - p[1]) * (p[4] - p[0])) continue;
    for (std::vector<double>* uv : {&triangles.uv, &triangles.oldUv})
      std::swap_ranges(&(*uv)[6 * t + 2], &(*uv)[6 * t + 4], &(*uv)[6 * t + 4]);
  }
}

/// The plane z = 0 with x = u and y = -v of the old uv, and old uv that `toOld` gives for new ones.
template <class ToOld>
BakeInput plane(const Image& map, const ToOld& toOld) {
  BakeInput out = test::squareWith(map, toOld);
  TangentInput before, after;
  BakeTriangles& triangles = out.triangles;
  faceForward(triangles);
  for (std::size_t c = 0; c < 6; ++c) {
    before.positions.insert(before.positions.end(),
                            {triangles.oldUv[2 * c], -triangles.oldUv[2 * c + 1], 0});
    before.normals.insert(before.normals.end(), {0, 0, 1});
  }
  before.uv = triangles.oldUv;
  after = before;
  after.uv = triangles.uv;
  triangles.normals = before.normals;
  triangles.oldTangents = mikkTangents(before);
  triangles.tangents = mikkTangents(after);
  return out;
}

}  // namespace

TEST_CASE("a plane keeps its lighting in a layout that is turned or mirrored") {
  const Image map = waves(256);
  const double c = std::cos(37 * kPi / 180), s = std::sin(37 * kPi / 180);
  for (const double mirror : {1.0, -1.0}) {
    const auto toOld = [&](const Point2& p) {
      const double x = mirror * (p[0] - 0.5), y = p[1] - 0.5;
      return Point2{0.5 + 0.6 * (c * x - s * y), 0.5 + 0.6 * (s * x + c * y)};
    };
    const BakeInput input = plane(map, toOld);
    BakeOptions options = asLargeAs(map);
    options.kind = MapKind::Normal;
    options.width = options.height = 180;
    const Image out = baked(input, options);
    CHECK(input.triangles.tangents[3] == mirror);
    double worst = 0;
    for (std::size_t y = 0; y < 180; ++y)
      for (std::size_t x = 0; x < 180; ++x) {
        const Point2 at = toOld({centreOf(x, y)[0] / 180, centreOf(x, y)[1] / 180});
        // Between four texels, of which the map has gentle waves.
        const double px = at[0] * 256 - 0.5, py = at[1] * 256 - 0.5;
        const auto i = static_cast<std::size_t>(px), j = static_cast<std::size_t>(py);
        const double fx = px - std::floor(px), fy = py - std::floor(py);
        Vec3 old{};
        old = sum(old, vectorIn(map, i, j), (1 - fx) * (1 - fy));
        old = sum(old, vectorIn(map, i + 1, j), fx * (1 - fy));
        old = sum(old, vectorIn(map, i, j + 1), (1 - fx) * fy);
        old = sum(old, vectorIn(map, i + 1, j + 1), fx * fy);
        const Vec3 before = lit(old, {0, 0, 1}, &input.triangles.oldTangents[0]);
        const Vec3 after = lit(vectorIn(out, x, y), {0, 0, 1}, &input.triangles.tangents[0]);
        for (std::size_t d = 0; d < 3; ++d) worst = std::max(worst, std::abs(before[d] - after[d]));
      }
    CHECK(worst <= 1.0 / 127);
  }
}

TEST_CASE("a normal map that stays is the same map") {
  const Image map = waves(64);
  BakeInput input = plane(map, unchanged);
  BakeOptions options = asLargeAs(map);
  options.kind = MapKind::Normal;
  const Image out = baked(input, options);
  for (std::size_t i = 0; i < out.bytes.size(); ++i)
    REQUIRE(std::abs(out.bytes[i] - map.bytes[i]) <= 1);
  SECTION("without a texture it is flat") {
    input.materials[0].texture = kNoTexture;
    const Image flat = baked(input, options);
    CHECK(flat.pixel(9, 9) == std::vector<int>{128, 128, 255});
  }
  SECTION("factors make it steeper") {
    input.materials[0].factor = {2, 2, 1, 1};
    const Image steep = baked(input, options);
    const Vec3 was = vectorIn(map, 20, 30), is = vectorIn(steep, 20, 30);
    CHECK(is[0] / is[2] == Approx(2 * was[0] / was[2]).margin(0.03));
  }
}
