#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "abflat/unwrap.h"
#include "catch.h"
#include "support/meshes.h"
#include "support/unwrapped.h"

using namespace abflat;
using namespace abflat::test;

namespace {

/// The next run with the same seams, in which known charts stay.
UnwrapOptions again(const UnwrapResult& first) {
  UnwrapOptions options = severalCharts();
  options.seams.isAuto = false;
  options.seams.edges = first.seams;
  options.reuse.known = knownLayout(first);
  options.reuse.keepsPlaces = true;
  return options;
}

std::array<double, 2> uvOf(const UnwrapResult& result, std::size_t corner) {
  const std::size_t i = 2 * std::size_t{result.vertexUv[result.triangles[corner]]};
  return {result.uv[i], result.uv[i + 1]};
}

/// Cuts around a face.
void cutOut(const PolygonMesh& mesh, std::size_t face, UnwrapOptions& options) {
  const std::uint32_t begin = mesh.faceOffsets[face], end = mesh.faceOffsets[face + 1];
  for (std::uint32_t c = begin; c < end; ++c)
    options.seams.edges.push_back(
        {mesh.faceVertices[c], mesh.faceVertices[c + 1 < end ? c + 1 : begin]});
}

template <typename Change>
void moveChart(std::uint32_t chart, KnownLayout& known, Change&& change) {
  std::vector<std::uint8_t> isMoved(known.vertexMap.size(), 0);
  for (std::size_t h = 0; h < known.triangles.size(); ++h) {
    const std::size_t v = known.triangles[h];
    if (known.chartOfTriangle[h / 3] != chart || isMoved[v]) continue;
    isMoved[v] = 1;
    change(&known.uv[2 * v]);
  }
}

std::size_t farthestInChart(const KnownLayout& known, std::size_t from, std::uint32_t chart) {
  std::size_t out = from;
  const auto distance = [&](std::size_t v) {
    return std::hypot(known.uv[2 * v] - known.uv[2 * from],
                      known.uv[2 * v + 1] - known.uv[2 * from + 1]);
  };
  for (std::size_t h = 0; h < known.triangles.size(); ++h)
    if (known.chartOfTriangle[h / 3] == chart && distance(known.triangles[h]) > distance(out))
      out = known.triangles[h];
  return out;
}

}  // namespace

TEST_CASE("charts that an edit does not change stay bit by bit", "[fixed]") {
  const PolygonMesh mesh = torus(24, 16);
  const UnwrapResult first = unwrapped(mesh, severalCharts());
  UnwrapOptions options = again(first);
  const std::vector<UnwrapChart>& charts = first.report.charts;
  const auto smallest = std::min_element(
      charts.begin(), charts.end(),
      [](const UnwrapChart& a, const UnwrapChart& b) { return a.faces < b.faces; });
  cutOut(mesh, smallest->firstFace, options);
  const UnwrapResult second = unwrapped(mesh, options);
  std::size_t moved = 0, stayed = 0, changed = 0;
  for (std::size_t h = 0; h < second.triangles.size(); ++h) {
    const bool stays = second.report.charts[second.chartOfTriangle[h / 3]].fixed;
    changed += !stays;
    stayed += stays;
    moved += stays && uvOf(first, h) != uvOf(second, h);
  }
  CHECK(moved == 0);
  CHECK(changed > 0);
  CHECK(stayed > changed);
  // The layout of all charts is known for the next run, whether they stay or not.
  for (const double x : second.unpacked) REQUIRE(std::isfinite(x));
}

TEST_CASE("with the same seams everything stays", "[fixed]") {
  const PolygonMesh mesh = torus(24, 16);
  const UnwrapResult first = unwrapped(mesh, severalCharts());
  const UnwrapResult second = unwrapped(mesh, again(first));
  CHECK(second.uv == first.uv);
  CHECK(second.report.atlas.utilization == Approx(first.report.atlas.utilization));
}

TEST_CASE("new charts get the texel density of those that stay", "[fixed]") {
  const PolygonMesh mesh = torus(24, 16);
  UnwrapOptions coarse = severalCharts();
  coarse.seams.isAuto = false;
  coarse.seams.edges = unwrapped(mesh, severalCharts()).seams;
  coarse.texelDensity = 10;
  const UnwrapResult first = unwrapped(mesh, coarse);
  UnwrapOptions options = again(first);
  cutOut(mesh, 0, options);
  const UnwrapResult second = unwrapped(mesh, options);
  CHECK(second.report.atlas.texelDensity == Approx(10).epsilon(0.01));
}

TEST_CASE("where nothing is packed, the texel density is measured", "[fixed]") {
  const PolygonMesh mesh = torus(24, 16);
  const UnwrapResult first = unwrapped(mesh, severalCharts());
  UnwrapOptions options = again(first);
  CHECK(unwrapped(mesh, options).report.atlas.texelDensity ==
        Approx(first.report.atlas.texelDensity).epsilon(1e-3));
  for (std::uint32_t i = 0; i < first.report.charts.size(); ++i)
    moveChart(i, options.reuse.known, [](double* uv) {
      for (std::size_t d = 0; d < 2; ++d) uv[d] /= 2;
    });
  CHECK(unwrapped(mesh, options).report.atlas.texelDensity ==
        Approx(first.report.atlas.texelDensity / 2).epsilon(1e-3));
}

TEST_CASE("charts that stay may leave the square, and the report says which", "[fixed]") {
  const PolygonMesh mesh = torus(24, 16);
  const UnwrapResult first = unwrapped(mesh, severalCharts());
  UnwrapOptions options = again(first);
  moveChart(1, options.reuse.known, [](double* uv) { uv[0] += 1; });
  const Result<UnwrapResult> second = unwrap(mesh, options);
  REQUIRE(second.ok());
  const UnwrapResult& result = second.value();
  CHECK_FALSE(result.report.valid);
  for (std::size_t h = 0; h < result.triangles.size(); ++h) {
    const bool isMoved = first.chartOfTriangle[h / 3] == 1;
    const UnwrapChart& chart = result.report.charts[result.chartOfTriangle[h / 3]];
    CHECK(chart.valid != isMoved);
    CHECK(chart.problem == (isMoved ? "it extends beyond its tile" : ""));
    CHECK(uvOf(result, h)[0] == uvOf(first, h)[0] + (isMoved ? 1 : 0));
    CHECK(uvOf(result, h)[1] == uvOf(first, h)[1]);
  }
}

TEST_CASE("charts that stay may overlap, and the report says which", "[fixed]") {
  const PolygonMesh mesh = torus(24, 16);
  const UnwrapResult first = unwrapped(mesh, severalCharts());
  std::array<double, 2> at{};  // inside a triangle
  for (std::size_t h = 0; h < 3; ++h)
    for (std::size_t d = 0; d < 2; ++d) at[d] += uvOf(first, h)[d] / 3;
  const std::uint32_t other = first.chartOfTriangle[0] == 0 ? 1 : 0;
  UnwrapOptions options = again(first);
  std::optional<std::array<double, 2>> from;
  moveChart(other, options.reuse.known, [&](double* uv) {
    if (!from) from = {uv[0], uv[1]};
    for (std::size_t d = 0; d < 2; ++d) uv[d] = at[d] + (uv[d] - (*from)[d]) / 1024;
  });
  const Result<UnwrapResult> second = unwrap(mesh, options);
  REQUIRE(second.ok());
  CHECK_FALSE(second.value().report.valid);
  std::size_t faulty = 0;
  for (const UnwrapChart& chart : second.value().report.charts) faulty += !chart.valid;
  CHECK(faulty >= 1);
  CHECK(faulty <= 2);
}

TEST_CASE("a mirrored chart stays, and the report says what is wrong", "[fixed]") {
  const PolygonMesh mesh = torus(24, 16);
  const UnwrapResult first = unwrapped(mesh, severalCharts());
  UnwrapOptions options = again(first);
  moveChart(1, options.reuse.known, [](double* uv) { uv[0] = 1 - uv[0]; });
  const Result<UnwrapResult> second = unwrap(mesh, options);
  REQUIRE(second.ok());
  CHECK_FALSE(second.value().report.valid);
  std::size_t mirrored = 0;
  for (const UnwrapChart& chart : second.value().report.charts)
    mirrored +=
        chart.problem == "where it stays, triangles are flipped or its boundary crosses itself";
  CHECK(mirrored == 1);
}

TEST_CASE("a chart whose shape was changed stays, even if it is folded now", "[fixed]") {
  const PolygonMesh mesh = torus(24, 16);
  const UnwrapResult first = unwrapped(mesh, severalCharts());
  UnwrapOptions options = again(first);
  // A vertex is dragged across its chart, to where another one is.
  const std::size_t dragged = options.reuse.known.triangles.front();
  const std::uint32_t chart = options.reuse.known.chartOfTriangle.front();
  const std::size_t onto = farthestInChart(options.reuse.known, dragged, chart);
  for (std::vector<double>* uv : {&options.reuse.known.uv, &options.reuse.known.unpacked})
    std::copy_n(&(*uv)[2 * onto], 2, &(*uv)[2 * dragged]);
  const Result<UnwrapResult> run = unwrap(mesh, options);
  REQUIRE(run.ok());
  const UnwrapResult& second = run.value();
  CHECK_FALSE(second.report.valid);
  for (std::size_t h = 0; h < second.triangles.size(); ++h) {
    const auto& now = second.report.charts[second.chartOfTriangle[h / 3]];
    CHECK(now.fixed);
    CHECK(now.valid == (options.reuse.known.chartOfTriangle[h / 3] != chart));
    CHECK(uvOf(second, h)[0] ==
          options.reuse.known.uv[2 * std::size_t{options.reuse.known.triangles[h]}]);
  }
  // Packed again, it is laid out again.
  options.reuse.keepsPlaces = false;
  CHECK(unwrapped(mesh, options).report.valid);
}

TEST_CASE("a known layout without usable uv cannot keep places", "[fixed]") {
  const PolygonMesh mesh = torus(12, 8);
  const UnwrapResult first = unwrapped(mesh, severalCharts());
  UnwrapOptions options = again(first);
  const auto messageOf = [&] {
    const Status s = unwrap(mesh, options).status();
    CHECK(s.code == StatusCode::InvalidOption);
    return s.message;
  };
  for (const double x : {double{NAN}, double{INFINITY}, -1e300}) {
    options.reuse.known.uv[7] = x;
    CHECK(
        messageOf() ==
        "charts cannot stay where they are known: the uv of vertex 3 is not a number from -10^6 to "
        "10^6");
  }
  options.reuse.known.uv.clear();
  CHECK(messageOf() == "the known layout has no uv, so charts cannot stay there");
}
