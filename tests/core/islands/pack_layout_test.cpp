#include "abflat/pack_layout.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "catch.h"

using namespace abflat;

namespace {

struct Rectangle {
  double u, v, width, height;
  bool isMirrored = false;
};

/// Separate quads in the plane z = 0, as large as in uv, each with its own texcoords.
PolygonMesh meshOf(const std::vector<Rectangle>& rectangles) {
  PolygonMesh mesh;
  mesh.faceOffsets = {0};
  for (const Rectangle& r : rectangles) {
    const double z = static_cast<double>(mesh.faceCount());
    for (const auto& [x, y] : {std::array<double, 2>{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
      const auto i = static_cast<std::uint32_t>(mesh.faceVertices.size());
      mesh.positions.insert(mesh.positions.end(), {x * r.width, y * r.height, z});
      const double across = r.isMirrored ? 1 - x : x;
      mesh.texcoords.insert(mesh.texcoords.end(), {r.u + across * r.width, r.v + y * r.height});
      mesh.faceVertices.push_back(i);
      mesh.faceTexcoords.push_back(i);
    }
    mesh.faceOffsets.push_back(static_cast<std::uint32_t>(mesh.faceVertices.size()));
  }
  return mesh;
}

PackLayoutResult packed(const PolygonMesh& mesh, const PackLayoutOptions& options = {}) {
  Result<PackLayoutResult> result = packLayout(mesh, options);
  INFO(result.status().message);
  REQUIRE(result.ok());
  CHECK(result.value().report.valid);
  return std::move(result.value());
}

std::array<double, 2> at(const PackLayoutResult& r, std::size_t corner) {
  const double* uv = &r.uv[2 * std::size_t{r.cornerUv[corner]}];
  return {uv[0], uv[1]};
}

/// Where an edge of a face points, as an angle from 0 to 2 pi.
double directionOf(const PackLayoutResult& r, std::size_t corner) {
  const auto a = at(r, corner), b = at(r, corner + 1);
  return std::atan2(b[1] - a[1], b[0] - a[0]);
}

double lengthOf(const PackLayoutResult& r, std::size_t corner) {
  const auto a = at(r, corner), b = at(r, corner + 1);
  return std::hypot(b[0] - a[0], b[1] - a[1]);
}

const std::vector<Rectangle> kApart = {
    {0.1, 0.1, 0.3, 0.1}, {0.6, 0.2, 0.1, 0.35}, {3.2, -4, 0.2, 0.2}, {0.5, 0.7, 0.05, 0.2, true}};

}  // namespace

TEST_CASE("pack layout: islands keep their shapes and their sizes beside each other") {
  const PackLayoutResult r = packed(meshOf(kApart));
  CHECK(r.report.islands == kApart.size());
  CHECK(r.report.mirrored == 1);
  CHECK(r.uv.size() == 2 * 4 * kApart.size());
  for (std::size_t i = 0; i < kApart.size(); ++i) {
    CHECK(lengthOf(r, 4 * i) == Approx(kApart[i].width * r.report.scale).epsilon(1e-9));
    CHECK(lengthOf(r, 4 * i + 1) == Approx(kApart[i].height * r.report.scale).epsilon(1e-9));
    const auto a = at(r, 4 * i), b = at(r, 4 * i + 1), c = at(r, 4 * i + 2);
    const double turn = (b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0]);
    CHECK((turn < 0) == kApart[i].isMirrored);
  }
  CHECK(r.report.utilization > 0.3);
}

TEST_CASE("pack layout: islands are turned as asked only") {
  PackLayoutOptions options;
  options.rotate = Rotate::None;
  const PackLayoutResult still = packed(meshOf(kApart), options);
  options.rotate = Rotate::Quarter;
  const PackLayoutResult quarter = packed(meshOf(kApart), options);
  for (std::size_t i = 0; i < kApart.size(); ++i) {
    const double before = kApart[i].isMirrored ? std::acos(-1.0) : 0;
    CHECK(std::abs(std::remainder(directionOf(still, 4 * i) - before, 2 * std::acos(-1.0))) < 1e-9);
    CHECK(std::abs(std::remainder(directionOf(quarter, 4 * i), std::acos(0.0))) < 1e-9);
  }
}

TEST_CASE("pack layout: a slanted island stays slanted unless it may be turned freely") {
  PolygonMesh mesh = meshOf({{0, 0, 0.5, 0.1}});
  for (std::size_t i = 0; i < mesh.texcoords.size(); i += 2) {
    const double u = mesh.texcoords[i], v = mesh.texcoords[i + 1];
    mesh.texcoords[i] = 0.8 * u - 0.6 * v;
    mesh.texcoords[i + 1] = 0.6 * u + 0.8 * v;
  }
  PackLayoutOptions options;
  options.rotate = Rotate::None;
  const PackLayoutResult still = packed(mesh, options);
  CHECK(directionOf(still, 0) == Approx(std::atan2(0.6, 0.8)).epsilon(1e-9));
  CHECK(packed(mesh).report.scale > 1.05 * still.report.scale);
}

TEST_CASE("pack layout: what lies on each other stays so, what barely overlaps is separated") {
  const PolygonMesh mesh = meshOf(
      {{0, 0, 0.4, 0.4}, {0.02, 0, 0.4, 0.4, true}, {0.38, 0, 0.3, 0.4}, {0.3, 0.3, 0.01, 0}});
  const PackLayoutResult r = packed(mesh);
  CHECK(r.report.islands == 4);
  CHECK(r.report.stackedIslands == 2);  // one of them without area
  CHECK(r.report.stackedStacks == 1);
  CHECK(r.report.separated == 3);
  const auto a = at(r, 0), b = at(r, 5);
  CHECK(std::hypot(a[0] - b[0], a[1] - b[1]) == Approx(0.02 * r.report.scale).epsilon(1e-9));
}

TEST_CASE("pack layout: islands of different materials have textures of their own") {
  PolygonMesh mesh = meshOf({{0, 0, 1, 1}, {0, 0, 1, 1}, {0, 0, 1, 1}, {0, 0, 1, 1, true}});
  mesh.faceMaterials = {0, 1, 1, 0};
  const PackLayoutResult r = packed(mesh);
  CHECK(r.report.stackedIslands == 2);
  CHECK(r.report.stackedStacks == 2);
  CHECK(r.report.separated == 4);
  CHECK(r.report.valid);
  // Neither what stays nor what is judged comes apart.
  PackLayoutOptions options;
  options.keepPlaces = true;
  CHECK(packed(mesh, options).report.stackedIslands == 3);
  options.keepPlaces = false;
  options.islands = {0};
  CHECK(packed(mesh, options).report.stackedIslands == 3);
}

TEST_CASE("pack layout: thousands of copies are one stack") {
  const PackLayoutResult r = packed(meshOf(std::vector<Rectangle>(3000, {0.2, 0.1, 0.3, 0.1})));
  CHECK(r.report.stackedIslands == 2999);
  CHECK(r.report.utilization == Approx(1.0 / 3).epsilon(0.02));
}

TEST_CASE("pack layout: faces are one island where values are equal, not only indices") {
  PolygonMesh mesh;
  mesh.positions = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
  mesh.faceOffsets = {0, 3, 6};
  mesh.faceVertices = {0, 1, 2, 3, 4, 5};
  mesh.texcoords = {0, 0, 1, 0, 0, 1, 1, 0, 1, 1, 0, 1};
  mesh.faceTexcoords = {0, 1, 2, 3, 4, 5};
  CHECK(packed(mesh).report.islands == 1);
  mesh.texcoords[6] = 1.001;
  CHECK(packed(mesh).report.islands == 2);
}

TEST_CASE("pack layout: one texel density, as asked") {
  PolygonMesh mesh = meshOf({{0, 0, 0.2, 0.2}, {0.5, 0, 0.2, 0.2}});
  for (std::size_t i = 12; i < 24; ++i) mesh.positions[i] *= 2;  // twice as large in 3D
  PackLayoutOptions options;
  CHECK(lengthOf(packed(mesh, options), 4) == Approx(lengthOf(packed(mesh, options), 0)));
  options.islandSizes = IslandSizes::Even;
  options.texelDensity = 500;
  const PackLayoutResult r = packed(mesh, options);
  CHECK(lengthOf(r, 0) * options.resolution.width == Approx(0.2 * 500));
  CHECK(lengthOf(r, 4) * options.resolution.width == Approx(0.4 * 500));
  CHECK(r.report.texelDensity == Approx(500));
}

TEST_CASE("pack layout: as many tiles as the density needs") {
  PackLayoutOptions options;
  options.texelDensity = 2900;
  options.udim = true;
  const PackLayoutResult r = packed(meshOf(kApart), options);
  CHECK(r.report.tiles > 1);
  options.udim = false;
  CHECK(packLayout(meshOf(kApart), options).status().code == StatusCode::AtlasTooSmall);
}

TEST_CASE("pack layout: it does not matter how faces are numbered") {
  std::vector<Rectangle> other = kApart;
  std::reverse(other.begin(), other.end());
  const PackLayoutResult a = packed(meshOf(kApart)), b = packed(meshOf(other));
  for (std::size_t i = 0; i < kApart.size(); ++i)
    for (std::size_t k = 0; k < 4; ++k) CHECK(at(a, 4 * i + k) == at(b, 4 * (3 - i) + k));
}

TEST_CASE("pack layout: texcoords that islands shared become two where they move apart") {
  PolygonMesh mesh = meshOf({{0, 0, 0.2, 0.2}, {0.2, 0, 0.2, 0.2}});
  mesh.faceTexcoords[4] = mesh.faceTexcoords[1];
  const PackLayoutResult r = packed(mesh);
  CHECK(r.uv.size() == 2 * 8);
  CHECK(r.cornerUv[1] != r.cornerUv[4]);
}

TEST_CASE("pack layout: faces without texcoords stay as they are") {
  PolygonMesh mesh = meshOf(kApart);
  mesh.faceTexcoords[0] = kNoTexcoord;
  mesh.texcoords[2 * 4] = std::numeric_limits<double>::quiet_NaN();
  const PackLayoutResult r = packed(mesh);
  CHECK(r.report.unmapped == 2);
  CHECK(r.cornerUv[0] == kNoTexcoord);
  CHECK(at(r, 1) == std::array<double, 2>{0.4, 0.1});
  CHECK(r.islandOfFace[1] == kNoIsland);
  CHECK(r.report.notes.size() == 1);
}

TEST_CASE("pack layout: what cannot be packed is refused") {
  PolygonMesh mesh = meshOf(kApart);
  mesh.texcoords.clear();
  mesh.faceTexcoords.clear();
  CHECK(packLayout(mesh, {}).status().code == StatusCode::NoTexcoords);
  CHECK(packLayout(PolygonMesh(), {}).status().code == StatusCode::EmptyMesh);
  mesh = meshOf(kApart);
  std::fill(mesh.faceTexcoords.begin(), mesh.faceTexcoords.end(), kNoTexcoord);
  CHECK(packLayout(mesh, {}).status().code == StatusCode::NoTexcoords);
  PackLayoutOptions options;
  options.udim = true;
  CHECK(packLayout(meshOf(kApart), options).status().code == StatusCode::InvalidOption);
}

TEST_CASE("pack layout: the caller may stop it at any time") {
  int all = 0;
  PackLayoutOptions options;
  options.progress = [&](const Progress&) { return ++all > 0; };
  packed(meshOf(kApart), options);
  for (int last = 1; last <= all; ++last) {
    int count = 0;
    options.progress = [&](const Progress&) { return ++count < last; };
    CHECK(packLayout(meshOf(kApart), options).status().code == StatusCode::Aborted);
  }
}

TEST_CASE("pack layout: areas of any unit, and layouts without area") {
  PolygonMesh mesh = meshOf(kApart);
  for (double& x : mesh.positions) x *= 1e200;
  CHECK(packed(mesh).report.texelDensity > 0);
  mesh = meshOf({{0.5, 0.5, 0, 0}, {0.25, 0.5, 0.5, 0}});
  CHECK(packed(mesh).report.texelDensity == 0);
}

TEST_CASE("pack layout: vertices stay, and are copied where islands that moved apart shared one") {
  PolygonMesh mesh;
  mesh.positions = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 2, 0, 0, 2, 1, 0, 7, 7, 7};
  mesh.faceOffsets = {0, 4, 8, 11};
  mesh.faceVertices = {0, 1, 2, 3, 1, 4, 5, 2, 0, 3, 5};
  mesh.texcoords = {0, 0, 1, 0, 1, 1, 0, 1, 5, 0, 6, 0, 6, 1, 5, 1};
  mesh.faceTexcoords = {0, 1, 2, 3, 4, 5, 6, 7, kNoTexcoord, kNoTexcoord, kNoTexcoord};
  const PackLayoutResult r = packed(mesh);
  const PackedVertices v = packedVertices(mesh, r);
  CHECK(v.islandOfTriangle == std::vector<std::uint32_t>{0, 0, 1, 1, kNoIsland});
  // 1 and 2 are in both squares; 0, 3 and 5 are in a triangle without texcoords, too.
  REQUIRE(v.vertexMap.size() == 7 + 5);
  for (std::uint32_t i = 0; i < 7; ++i) CHECK(v.vertexMap[i] == i);
  CHECK(v.uv.size() == 2 * v.vertexMap.size());
  CHECK(v.uv[12] == 0);  // no face has vertex 6
  REQUIRE(v.triangles.size() == r.triangleCorners.size());
  for (std::size_t i = 0; i < v.triangles.size(); ++i) {
    const std::uint32_t c = r.triangleCorners[i], at = v.triangles[i];
    CHECK(v.vertexMap[at] == mesh.faceVertices[c]);
    const std::array<double, 2> uv =
        r.cornerUv[c] == kNoTexcoord ? std::array<double, 2>{} : ::at(r, c);
    CHECK(std::array<double, 2>{v.uv[2 * at], v.uv[2 * at + 1]} == uv);
  }
}

TEST_CASE("pack layout: what stays where it is comes back as it was, and is judged") {
  const PolygonMesh mesh = meshOf({{0.1, 0.1, 0.3, 0.3},
                                   {0.35, 0.1, 0.3, 0.3},
                                   {0.1, 0.6, 0.2, 0.2, true},
                                   {1.9, 0.5, 0.2, 0.2},
                                   {0.7, 0.7, 0.1, 0}});
  PackLayoutOptions options;
  options.keepPlaces = true;
  Result<PackLayoutResult> result = packLayout(mesh, options);
  REQUIRE(result.ok());
  const PackLayoutResult& r = result.value();
  CHECK(r.uv == mesh.texcoords);
  CHECK(r.report.islands == 5);
  CHECK(r.report.scale == 1);
  CHECK(r.report.utilization == r.report.utilizationBefore);
  CHECK(r.report.facesOverlapping == 2);
  CHECK(r.report.facesFlipped == 1);
  CHECK(r.report.facesOutside == 1);
  CHECK(r.report.facesEmpty == 1);
  CHECK_FALSE(r.report.valid);
  CHECK(r.faults.size() == r.triangleCorners.size() / 3);
  for (const Precision precision : {Precision::Single, Precision::Gltf}) {
    PolygonMesh rounded = mesh;
    options.precision = precision;
    rounded.texcoords = packLayout(mesh, options).value().uv;
    CHECK(packLayout(rounded, options).value().uv == rounded.texcoords);
  }
}

TEST_CASE("pack layout: what stays is judged by the tiles that it is in, if there are several") {
  const PolygonMesh mesh = meshOf({{0.1, 0.1, 0.3, 0.3}, {1.2, 0.1, 0.3, 0.3}});
  PackLayoutOptions options;
  options.keepPlaces = true;
  CHECK(packLayout(mesh, options).value().report.facesOutside == 1);
  options.udim = true;
  const PackLayoutResult r = packed(mesh, options);
  CHECK(r.report.facesOutside == 0);
  CHECK(r.report.tiles == 2);
}

TEST_CASE("pack layout: faults of triangles are in the order of the mesh, without an island none") {
  PolygonMesh mesh = meshOf({{2, 2, 0.3, 0.3}, {0.1, 0.1, 0.3, 0.3}, {3, 3, 0.1, 0.1}});
  for (std::size_t c = 0; c < 4; ++c) mesh.faceTexcoords[c] = kNoTexcoord;
  PackLayoutOptions options;
  options.keepPlaces = true;
  const auto outside = static_cast<std::uint8_t>(UvFault::Outside);
  CHECK(packLayout(mesh, options).value().faults ==
        std::vector<std::uint8_t>{0, 0, 0, 0, outside, outside});
}

TEST_CASE("pack layout: only some islands are packed, around the others, and none of them grows") {
  const PolygonMesh mesh =
      meshOf({{0.1, 0.1, 0.3, 0.3}, {0.3, 0.2, 0.3, 0.1}, {0.6, 0.6, 0.2, 0.2}});
  PackLayoutOptions options;
  options.islands = {1};
  const PackLayoutResult r = packed(mesh, options);
  for (std::size_t corner = 0; corner < 12; ++corner) {
    if (corner / 4 == 1) continue;
    CHECK(at(r, corner)[0] == mesh.texcoords[2 * corner]);
    CHECK(at(r, corner)[1] == mesh.texcoords[2 * corner + 1]);
  }
  CHECK(lengthOf(r, 4) == Approx(0.3).epsilon(0.01));
  CHECK(lengthOf(r, 4) <= 0.3 + 1e-9);
  options.islands = {3};
  CHECK(packLayout(mesh, options).status().code == StatusCode::InvalidOption);
}

TEST_CASE("pack layout: each island goes to the tile that is asked for, as large as can be") {
  const PolygonMesh mesh =
      meshOf({{0.1, 0.1, 0.3, 0.3}, {0.5, 0.1, 0.3, 0.2}, {0.1, 0.6, 0.1, 0.1}});
  PackLayoutOptions options;
  options.tileOfIsland = {0, 0, 11};
  const PackLayoutResult r = packed(mesh, options);
  CHECK(r.report.tiles == 12);
  for (std::size_t corner = 0; corner < 12; ++corner) {
    const double tile = corner < 8 ? 0 : 1;
    CHECK(std::floor(at(r, corner)[0]) == tile);
    CHECK(std::floor(at(r, corner)[1]) == tile);
  }
  CHECK(lengthOf(r, 8) > 0.99);
  options.tileOfIsland = {0, 0};
  CHECK(packLayout(mesh, options).status().code == StatusCode::InvalidOption);
  options.tileOfIsland = {0, 0, 9999};
  CHECK(packLayout(mesh, options).status().code == StatusCode::InvalidOption);
}

TEST_CASE("pack layout: other texcoords take the place of those of the mesh") {
  PolygonMesh mesh = meshOf({{0.1, 0.1, 0.3, 0.3}, {0.5, 0.1, 0.3, 0.2}});
  // Both faces use the same texcoords.
  std::copy_n(mesh.faceTexcoords.begin(), 4, mesh.faceTexcoords.begin() + 4);
  PackLayoutOptions options;
  options.keepPlaces = true;
  const PackLayoutResult before = packLayout(mesh, options).value();
  std::vector<double> uv;
  for (const std::uint32_t corner : before.triangleCorners)
    for (const double x : at(before, corner)) uv.push_back(x + (corner < 4 ? 0 : 0.5));
  REQUIRE(replaceTexcoords(mesh, uv).ok());
  const PackLayoutResult now = packLayout(mesh, options).value();
  CHECK(now.uv.size() == 16);
  for (std::size_t i = 0; i < now.triangleCorners.size(); ++i)
    for (std::size_t d = 0; d < 2; ++d) CHECK(at(now, now.triangleCorners[i])[d] == uv[2 * i + d]);
  uv.pop_back();
  CHECK(replaceTexcoords(mesh, uv).code == StatusCode::InvalidMesh);
}
