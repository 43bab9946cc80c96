#include "unwrap/flat_faces.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "catch.h"
#include "support/unwrapped.h"

using namespace abflat;
using namespace abflat::test;

namespace {

constexpr unsigned kSides = 24;

/// Turned about the y axis, from radii and heights, closed by a polygon at either end.
PolygonMesh turned(const std::vector<std::pair<double, double>>& profile) {
  constexpr double kTurn = 6.283185307179586;
  PolygonMesh mesh;
  mesh.faceOffsets.push_back(0);
  const auto face = [&](const std::vector<std::uint32_t>& corners) {
    mesh.faceVertices.insert(mesh.faceVertices.end(), corners.begin(), corners.end());
    mesh.faceOffsets.push_back(static_cast<std::uint32_t>(mesh.faceVertices.size()));
  };
  std::vector<std::uint32_t> bottom, top;
  for (std::uint32_t row = 0; row < profile.size(); ++row)
    for (std::uint32_t i = 0; i < kSides; ++i) {
      const double angle = kTurn * i / kSides, radius = profile[row].first;
      mesh.positions.insert(mesh.positions.end(), {radius * std::cos(angle), profile[row].second,
                                                   -radius * std::sin(angle)});
      const std::uint32_t next = (i + 1) % kSides, a = kSides * row, b = a + kSides;
      if (row + 1 < profile.size()) face({a + i, a + next, b + next, b + i});
      if (row == 0) bottom.insert(bottom.begin(), i);
      if (row + 1 == profile.size()) top.push_back(a + i);
    }
  face(bottom);
  face(top);
  return mesh;
}

/// The longest side of a polygon in the layout by its shortest one.
double unevenness(const PolygonMesh& mesh, const UnwrapResult& layout, std::size_t face) {
  const std::uint32_t first = mesh.faceOffsets[face], end = mesh.faceOffsets[face + 1];
  double shortest = 1, longest = 0;
  for (std::uint32_t c = first; c < end; ++c) {
    const double* a = &layout.unpacked[2 * layout.cornerUv[c]];
    const double* b = &layout.unpacked[2 * layout.cornerUv[c + 1 < end ? c + 1 : first]];
    const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
    shortest = std::min(shortest, length);
    longest = std::max(longest, length);
  }
  return longest / shortest;
}

}  // namespace

TEST_CASE("the ends of a bottle are discs, although its shoulders are bent", "[unwrap]") {
  const PolygonMesh bottle = turned({{1, 0},
                                     {1, 2.4},
                                     {0.95, 2.7},
                                     {0.8, 2.95},
                                     {0.5, 3.2},
                                     {0.35, 3.4},
                                     {0.35, 4.2},
                                     {0.42, 4.2},
                                     {0.42, 4.5}});
  const UnwrapResult layout = unwrapped(bottle, {});
  for (const std::size_t face : {bottle.faceCount() - 2, bottle.faceCount() - 1})
    CHECK(unevenness(bottle, layout, face) < 1.001);
  CHECK(layout.report.charts.size() <= 5);
  SECTION("where only lengths count, they stay where they hang") {
    UnwrapOptions options;
    options.seamCosts = SeamCosts::Length;
    CHECK(unwrapped(bottle, options).report.charts.size() < layout.report.charts.size());
  }
}

TEST_CASE("a cylinder, which unrolls, is a strip and two discs at most", "[unwrap]") {
  const PolygonMesh mesh = turned({{1, 0}, {1, 3}});
  const UnwrapResult layout = unwrapped(mesh, {});
  for (const std::size_t face : {mesh.faceCount() - 2, mesh.faceCount() - 1})
    CHECK(unevenness(mesh, layout, face) < 1.001);
  CHECK(layout.report.charts.size() <= 3);
}
