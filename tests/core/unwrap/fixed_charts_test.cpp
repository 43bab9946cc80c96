#include <algorithm>

#include "abflat/unwrap.h"
#include "catch.h"
#include "support/meshes.h"
#include "support/unwrapped.h"

using namespace abflat;
using namespace abflat::test;

namespace {

/// Checks that triangles of these charts keep their uv, and that all others are in charts that are
/// not fixed.
void checkStayed(const UnwrapResult& before, const UnwrapResult& after,
                 const std::vector<std::uint32_t>& charts) {
  REQUIRE(before.chartOfTriangle.size() == after.chartOfTriangle.size());
  std::size_t moved = 0, wrong = 0;
  for (std::size_t t = 0; t < after.chartOfTriangle.size(); ++t) {
    const bool stays = std::count(charts.begin(), charts.end(), before.chartOfTriangle[t]) > 0;
    wrong += stays != after.report.charts[after.chartOfTriangle[t]].fixed;
    for (std::size_t h = 3 * t; stays && h < 3 * t + 3; ++h)
      for (std::size_t d = 0; d < 2; ++d)
        moved += before.uv[2 * before.vertexUv[before.triangles[h]] + d] !=
                 after.uv[2 * after.vertexUv[after.triangles[h]] + d];
  }
  CHECK(wrong == 0);
  CHECK(moved == 0);
  CHECK(static_cast<std::size_t>(
            std::count_if(after.report.charts.begin(), after.report.charts.end(),
                          [](const UnwrapChart& c) { return c.fixed; })) == charts.size());
}

PolygonMesh withOwnUv(PolygonMesh mesh) {
  mesh.texcoords = {0, 0, 1, 0, 0, 1};
  for (std::size_t c = 0; c < mesh.faceVertices.size(); ++c)
    mesh.faceTexcoords.push_back(static_cast<std::uint32_t>(c % 3));
  return mesh;
}

}  // namespace

TEST_CASE("known charts stay bit by bit, whatever the options are then", "[fixed]") {
  for (const PolygonMesh& mesh : {torus(24, 16), withOwnUv(torus(24, 16))}) {
    const UnwrapResult first = unwrapped(mesh, severalCharts());
    REQUIRE(first.report.charts.size() > 3);
    std::vector<UnwrapOptions> others(5, severalCharts());
    others[0].maxStretch = 1.3;
    others[1].seams.sharpDegrees = 10;
    others[2].straightSeams = true;
    others[3].t = 1;
    others[3].padding = 4;
    others[4].seams.isAuto = false;
    others[4].seams.edges = {{0, 1}};
    for (UnwrapOptions& options : others) {
      options.reuse.known = knownLayout(first);
      options.reuse.fixedCharts = {2, 0};
      const UnwrapResult second = unwrapped(mesh, options);
      checkStayed(first, second, {0, 2});
      // And once more, starting from what is already fixed.
      std::vector<std::uint32_t> fixed;
      for (std::uint32_t i = 0; i < second.report.charts.size(); ++i)
        if (second.report.charts[i].fixed) fixed.push_back(i);
      options.reuse.known = knownLayout(second);
      options.reuse.fixedCharts = fixed;
      options.maxStretch = 1.01;
      checkStayed(second, unwrapped(mesh, options), fixed);
    }
  }
}

TEST_CASE("charts and faces can be fixed at once", "[fixed]") {
  const PolygonMesh plain = torus(24, 16);
  const UnwrapResult first = unwrapped(plain, severalCharts());
  PolygonMesh mesh = plain;
  mesh.texcoords = first.uv;
  mesh.faceTexcoords = first.cornerUv;
  UnwrapOptions options = severalCharts();
  options.reuse.known = knownLayout(first);
  options.reuse.fixedFaces = {first.report.charts[1].firstFace};
  options.reuse.fixedCharts = {0};
  checkStayed(first, unwrapped(mesh, options), {0, 1});
}

TEST_CASE("polygons and separate triangles can stay as charts", "[fixed]") {
  const PolygonMesh mesh = torus(12, 8);
  PolygonMesh soup;
  std::vector<std::uint32_t> corners;
  for (const std::size_t v : mesh.faceVertices) {
    corners.push_back(static_cast<std::uint32_t>(corners.size()));
    for (std::size_t d = 0; d < 3; ++d) soup.positions.push_back(mesh.positions[3 * v + d]);
  }
  soup = makeTriangleMesh(soup.positions, corners);
  for (const PolygonMesh& m : {soup, star(7)}) {
    const UnwrapResult first = unwrapped(m, severalCharts());
    UnwrapOptions options = severalCharts();
    options.maxStretch = 1.5;
    options.reuse.known = knownLayout(first);
    options.reuse.fixedCharts = {0};
    checkStayed(first, unwrapped(m, options), {0});
  }
}

TEST_CASE("charts that cannot stay are named", "[fixed]") {
  const PolygonMesh mesh = torus(12, 8);
  const UnwrapResult first = unwrapped(mesh, severalCharts());
  UnwrapOptions options = severalCharts();
  const auto messageOf = [&] {
    const Status s = unwrap(mesh, options).status();
    CHECK(s.code == StatusCode::InvalidOption);
    return s.message;
  };
  options.reuse.fixedCharts = {0};
  CHECK(messageOf().find("the known layout belongs to another mesh") == 0);
  options.reuse.known = knownLayout(first);
  options.reuse.fixedCharts = {0, 77};
  CHECK(messageOf() == "chart 77 cannot stay fixed: the known layout has no such chart");
  options.reuse.fixedCharts = {0};
  options.reuse.known.uv.clear();
  CHECK(messageOf() == "the known layout has no uv for the fixed charts");
}
