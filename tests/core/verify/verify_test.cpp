#include "abflat/verify.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "abflat/pack_layout.h"
#include "catch.h"
#include "support/meshes.h"
#include "support/unwrapped.h"

using namespace abflat;
using namespace abflat::test;

namespace {

struct Square {
  double u, v, side;
  bool isMirrored = false;
};

/// Separate quads in the plane z = 0, as large as in uv, each with its own texcoords.
PolygonMesh quads(const std::vector<Square>& squares) {
  PolygonMesh mesh;
  mesh.faceOffsets = {0};
  for (const Square& s : squares) {
    const double z = static_cast<double>(mesh.faceCount());
    for (const auto& [x, y] : {std::array<double, 2>{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
      const auto i = static_cast<std::uint32_t>(mesh.faceVertices.size());
      mesh.positions.insert(mesh.positions.end(), {x * s.side, y * s.side, z});
      const double across = s.isMirrored ? 1 - x : x;
      mesh.texcoords.insert(mesh.texcoords.end(), {s.u + across * s.side, s.v + y * s.side});
      mesh.faceVertices.push_back(i);
      mesh.faceTexcoords.push_back(i);
    }
    mesh.faceOffsets.push_back(static_cast<std::uint32_t>(mesh.faceVertices.size()));
  }
  return mesh;
}

VerifyReport verified(const PolygonMesh& mesh, const VerifyOptions& options = {}) {
  const Result<VerifyResult> result = verifyLayout(mesh, options);
  INFO(result.status().message);
  REQUIRE(result.ok());
  CHECK(result.value().faults.size() * 3 == result.value().triangleCorners.size());
  return result.value().report;
}

/// The rules of what was found, in order, as text.
std::string rulesOf(const VerifyReport& report) {
  std::string out;
  for (const VerifyFinding& found : report.findings) {
    CHECK_FALSE(found.message.empty());
    out += (out.empty() ? "" : " ") + std::string(nameOf(found.rule));
  }
  CHECK(report.valid == report.findings.empty());
  return out;
}

std::string rulesOf(const PolygonMesh& mesh, const VerifyOptions& options = {}) {
  return rulesOf(verified(mesh, options));
}

PolygonMesh withLayout(PolygonMesh mesh, const UnwrapResult& result) {
  mesh.texcoords = result.uv;
  mesh.faceTexcoords = result.cornerUv;
  return mesh;
}

}  // namespace

TEST_CASE("an atlas of abflat keeps to what it was made for, and measures what its report says",
          "[verify]") {
  const PolygonMesh mesh = torus(24, 16);
  UnwrapOptions making = severalCharts();
  making.resolution = {512, 256};
  making.padding = 4;
  const UnwrapResult made = unwrapped(mesh, making);
  VerifyOptions options;
  options.resolution = making.resolution;
  options.padding = making.padding;
  options.margin = 2;
  options.maxStretch = making.maxStretch;
  options.maxIslands = static_cast<int>(made.report.charts.size());
  const VerifyReport report = verified(withLayout(mesh, made), options);
  CHECK(rulesOf(report) == "");
  CHECK(report.islands == made.report.charts.size());
  CHECK(report.distanceIslands >= 4);
  CHECK(report.distanceIslands < 8);
  CHECK(report.distanceEdge >= 2);
  CHECK(report.symmetricDirichlet == Approx(made.report.symmetricDirichlet).epsilon(1e-6));
  CHECK(report.quasiConformalMean == Approx(made.report.quasiConformalMean).epsilon(1e-6));
  CHECK(report.texelDensityMean == Approx(made.report.atlas.texelDensity).epsilon(0.01));
  CHECK(report.texelDensityRatio == Approx(1).epsilon(0.05));
  CHECK(report.utilization == Approx(made.report.atlas.utilization).epsilon(1e-6));
  CHECK(report.tiles == std::vector<std::uint32_t>{1001});
  // One step beyond each limit.
  const auto beyond = [&](const auto& change) {
    VerifyOptions asked = options;
    change(asked);
    return rulesOf(withLayout(mesh, made), asked);
  };
  CHECK(beyond([&](VerifyOptions& o) {
          o.padding = report.distanceIslands + 0.01;
        }).find("padding") == 0);
  CHECK(beyond([&](VerifyOptions& o) { o.padding = report.distanceIslands - 0.01; }) == "");
  CHECK(beyond([&](VerifyOptions& o) { o.margin = report.distanceEdge + 0.01; }).find("margin") ==
        0);
  CHECK(beyond([&](VerifyOptions& o) { o.minIslandWidth = report.narrowest + 0.01; }) == "thin");
  CHECK(beyond([&](VerifyOptions& o) { o.minIslandWidth = report.narrowest - 0.01; }) == "");
  CHECK(beyond([&](VerifyOptions& o) { o.minTexelDensity = 1.01 * report.texelDensityMin; }) ==
        "density");
  CHECK(beyond([&](VerifyOptions& o) { o.minTexelDensity = 0.99 * report.texelDensityMin; }) == "");
  CHECK(beyond([&](VerifyOptions& o) { o.maxTexelDensity = 0.99 * report.texelDensityMax; }) ==
        "density");
  CHECK(beyond([&](VerifyOptions& o) {
          o.maxStretch = 1 + 0.9 * (report.worstStretch - 1);
        }).find("stretch") == 0);
  CHECK(beyond([&](VerifyOptions& o) { o.minUtilization = report.utilization + 0.01; }) ==
        "utilization");
  REQUIRE(report.islands > 1);
  CHECK(beyond([&](VerifyOptions& o) { o.maxIslands = 1; }) == "islands");
  CHECK(beyond([&](VerifyOptions& o) { o.mipLevels = 1; }).find("padding") == 0);
}

TEST_CASE("distances are in texels, and half as many in each mip level", "[verify]") {
  const PolygonMesh mesh = quads({{0.1, 0.1, 0.3}, {0.5, 0.1, 0.3}, {0.1, 0.75, 0.2}});
  VerifyOptions options;
  options.resolution = {200, 100};
  const VerifyReport report = verified(mesh, options);
  CHECK(report.distanceIslands == Approx(20));  // across; up it is 35
  CHECK(report.distanceEdge == Approx(5));
  CHECK(report.narrowest == Approx(20));
  options.padding = 19;
  CHECK(rulesOf(mesh, options) == "");
  options.padding = 21;
  CHECK(rulesOf(mesh, options) == "padding");
  options.padding = 9;
  options.mipLevels = 1;
  CHECK(rulesOf(mesh, options) == "");
  options.padding = 11;
  CHECK(rulesOf(mesh, options) == "padding");
  options.padding = 0;
  options.margin = 2.4;
  CHECK(rulesOf(mesh, options) == "");
  options.margin = 2.6;
  CHECK(rulesOf(mesh, options) == "margin");
}

TEST_CASE("what overlaps is told apart from what is stacked", "[verify]") {
  const PolygonMesh stacked = quads({{0.1, 0.1, 0.3}, {0.1, 0.1, 0.3}, {0.6, 0.6, 0.2}});
  CHECK(rulesOf(stacked) == "stacked");
  VerifyOptions options;
  options.allowStacked = true;
  const VerifyReport report = verified(stacked, options);
  CHECK(rulesOf(report) == "");
  CHECK(report.overlappingStacked == 1);
  CHECK(report.overlappingPairs == 0);
  CHECK(report.facesOverlapping == 2);
  CHECK(report.utilization == Approx(0.09 + 0.04));
  CHECK(report.distanceIslands == Approx(1024 * std::hypot(0.2, 0.2)));

  const PolygonMesh partly = quads({{0.1, 0.1, 0.3}, {0.2, 0.2, 0.3}, {0.6, 0.6, 0.2}});
  CHECK(rulesOf(partly, options) == "overlapBetween");
  const VerifyReport found = verified(partly, options);
  CHECK(found.overlappingPairs == 1);
  CHECK(found.findings[0].islands == std::vector<std::uint32_t>{0, 1});
  CHECK(found.findings[0].faces == std::vector<std::uint32_t>{0, 1});
  options.allowOverlaps = true;
  CHECK(rulesOf(partly, options) == "");
}

TEST_CASE("an island that folds over overlaps itself", "[verify]") {
  PolygonMesh mesh = quads({{0.1, 0.1, 0.4}});
  // Two triangles of the square, the second of which is folded back onto the first.
  mesh.faceOffsets = {0, 3, 6};
  mesh.faceVertices = mesh.faceTexcoords = {0, 1, 2, 0, 2, 3};
  CHECK(rulesOf(mesh) == "");
  mesh.texcoords[6] = 0.45;
  mesh.texcoords[7] = 0.2;
  const VerifyReport report = verified(mesh);
  CHECK(rulesOf(report) == "flipped overlap");
  CHECK(report.overlappingThemselves == 1);
  CHECK(report.findings[0].faces == std::vector<std::uint32_t>{1});
}

TEST_CASE("mirrored islands may be allowed, single faces not", "[verify]") {
  PolygonMesh mesh = quads({{0.1, 0.1, 0.3}, {0.5, 0.1, 0.3, true}});
  CHECK(rulesOf(mesh) == "flipped");
  VerifyOptions options;
  options.allowMirrored = true;
  CHECK(rulesOf(mesh, options) == "");
  CHECK(verified(mesh, options).mirrored == 1);
}

TEST_CASE("faces without area or texcoords are found", "[verify]") {
  PolygonMesh mesh = quads({{0.1, 0.1, 0.3}, {0.5, 0.1, 0.3}});
  for (std::size_t i = 8; i < 16; i += 2) mesh.texcoords[i + 1] = 0.2;
  CHECK(rulesOf(mesh) == "empty");
  VerifyOptions options;
  options.allowEmpty = true;
  CHECK(rulesOf(mesh, options) == "");
  mesh.faceTexcoords[5] = kNoTexcoord;
  CHECK(rulesOf(mesh) == "unmapped");
  CHECK(verified(mesh).unmapped == 1);
  options.allowUnmapped = true;
  CHECK(rulesOf(mesh, options) == "");
  // A face without area may have none.
  PolygonMesh flat = quads({{0.1, 0.1, 0.3}, {0.5, 0.1, 0}});
  CHECK(rulesOf(flat) == "");
}

TEST_CASE("each island has to lie in one tile", "[verify]") {
  VerifyOptions options;
  CHECK(rulesOf(quads({{-0.1, 0.1, 0.3}, {0.5, 0.1, 0.3}})) == "outside");
  CHECK(rulesOf(quads({{0.8, 0.1, 0.3}})) == "outside");
  CHECK(rulesOf(quads({{1.1, 0.1, 0.3}})) == "outside");
  options.allowOutsideTiles = true;
  CHECK(rulesOf(quads({{1.1, 0.1, 0.3}}), options) == "");
  options = {};
  options.udim = true;
  const PolygonMesh tiles = quads({{0.2, 0.1, 0.75}, {1.05, 0.1, 0.3}, {9.1, 2.1, 0.3}});
  const VerifyReport report = verified(tiles, options);
  CHECK(rulesOf(report) == "");
  CHECK(report.tiles == std::vector<std::uint32_t>{1001, 1002, 1030});
  CHECK(report.utilization == Approx((0.5625 + 0.09 + 0.09) / 3));
  // Those of two tiles are in two textures.
  options.padding = 200;
  CHECK(rulesOf(tiles, options) == "");
  for (const auto& [u, v] :
       {std::array<double, 2>{0.8, 0.1}, {-0.9, 0.1}, {10.1, 0.1}, {0.1, -0.5}})
    CHECK(rulesOf(quads({{u, v, 0.3}}), options).find("outside") == 0);
}

TEST_CASE("islands that differ in density are found", "[verify]") {
  PolygonMesh mesh = quads({{0.1, 0.1, 0.3}, {0.5, 0.1, 0.3}});
  for (std::size_t i = 12; i < 24; ++i)
    if (i % 3 < 2) mesh.positions[i] *= 4;
  const VerifyReport report = verified(mesh);
  CHECK(report.texelDensityMax == Approx(1024));
  CHECK(report.texelDensityMin == Approx(256));
  CHECK(report.texelDensityRatio == Approx(4));
  CHECK(report.symmetricDirichlet == Approx(1));
  VerifyOptions options;
  options.maxDensityRatio = 3.9;
  CHECK(rulesOf(mesh, options) == "densityRatio");
  options.maxDensityRatio = 4.1;
  CHECK(rulesOf(mesh, options) == "");
}

TEST_CASE("figures do not depend on the unit of the mesh or its order", "[verify]") {
  const PolygonMesh mesh = torus(12, 8);
  const UnwrapResult made = unwrapped(mesh, severalCharts());
  const PolygonMesh first = withLayout(mesh, made);
  const VerifyReport expected = verified(first);
  PolygonMesh scaled = first;
  for (double& x : scaled.positions) x = std::ldexp(x, 500);
  const VerifyReport large = verified(scaled);
  CHECK(large.symmetricDirichlet == expected.symmetricDirichlet);
  CHECK(large.texelDensityMean == std::ldexp(expected.texelDensityMean, -500));
  PolygonMesh turned = first;
  std::reverse(turned.faceVertices.begin(), turned.faceVertices.end());
  std::reverse(turned.faceTexcoords.begin(), turned.faceTexcoords.end());
  const VerifyReport other = verified(turned);
  CHECK(other.distanceIslands == expected.distanceIslands);
  CHECK(other.facesFlipped == mesh.faceCount());
  CHECK(other.utilization == Approx(expected.utilization).epsilon(1e-12));
}

TEST_CASE("verify: what it cannot judge has a reason", "[verify]") {
  CHECK(verifyLayout({}, {}).status().code == StatusCode::EmptyMesh);
  CHECK(verifyLayout(torus(12, 8), {}).status().code == StatusCode::NoTexcoords);
  PolygonMesh broken = quads({{0.1, 0.1, 0.3}});
  broken.faceTexcoords[0] = 77;
  CHECK(verifyLayout(broken, {}).status().code == StatusCode::InvalidMesh);
  VerifyOptions options;
  options.progress = [](const Progress&) { return false; };
  CHECK(verifyLayout(quads({{0.1, 0.1, 0.3}}), options).status().code == StatusCode::Aborted);
}
